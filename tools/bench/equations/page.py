"""Tables in docs/performance.md: each stands between two marks and is replaced as a whole."""

import os
import platform

PAGE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../../docs/performance.md")


def replace(name, text):
    begin, end = f"<!-- {name}: begin -->\n", f"<!-- {name}: end -->"
    with open(PAGE) as page:
        before, _, rest = page.read().partition(begin)
    _, mark, after = rest.partition(end)
    if not mark:
        raise SystemExit(f"{PAGE} has no place for {name}")
    with open(PAGE, "w") as page:
        page.write(before + begin + text.strip() + "\n" + end + after)


def machine():
    """What the numbers were measured on, without names."""
    return f"{platform.machine()}, one core"
