"""The base of the enumerations: an answer is compared, and is not a truth value."""

import enum


class Answer(enum.Enum):
    def __bool__(self):
        raise TypeError(f"{self} is not a truth value; compare it: x is {self}")

    def __repr__(self):
        return f"{type(self).__name__}.{self.name}"

    __str__ = __repr__
