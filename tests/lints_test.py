"""Rules of the house that no compiler knows, for lib: no error is swallowed without a word, values are not compared
as texts, a room has one type of a name, comments name what they speak of, no class grows beyond measure.
Usage: lints_test.py SOURCE_DIR"""
import collections
import os
import re
import sys

# Comments that begin with a genitive or a relative clause whose noun is elsewhere.  None may be added: take one
# away, and lower the number.
most_beginnings = {"Of": 0, "Those": 0, "What": 0, "Where": 0, "Whose": 0}

# The classes with more than this many lines, and how many they have.  None may grow and none may be added; those
# of certify and theorem are not counted until the proof has one home.
most_lines = 300
not_counted = ("certify", "theorem")
long_classes = {
    "flow/field/field_stepper.hpp FieldStepper": 597,
    "flow/field/machine_code.cpp Emitter": 445,
}

labels = "Errors|Throws|Cost|Requires|Shape|Source"
silent_catch = re.compile(r"catch \([^)]*\) \{\s*(?://[^\n]*\s*)*\}")
compared_texts = re.compile(r"to_string\((?:[^()]|\([^()]*\))*\)\s*[=!]=\s*to_string\(")
beginning = re.compile(r"^[ \t]*//[/!]?<?[ \t]*(Of|Those|What|Where|Whose)\b", re.M)
swallowed_label = re.compile(rf"^[ \t]*///.*\w (?:{labels})  +\S", re.M)
not_code = re.compile(r'R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'|//[^\n]*|/\*.*?\*/'
                      r'|^[ \t]*#(?:[^\n\\]|\\.|\\\n)*', re.S | re.M)
head_of_type = re.compile(r"(?:^|[\s>])(?:struct|class|enum class|enum|union)\s+((?:\w+::)*\w+)(<[^;{]*>)?"
                          r"\s*(?:final)?\s*(?::[^:][^;{]*)?$", re.S)

Type = collections.namedtuple("Type", "name first last")


def code_of(text):
    """Without comments, texts and lines of the preprocessor; all lines stay where they are."""
    return not_code.sub(lambda m: re.sub(r"[^\n]", " ", m[0]), text)


def types_of(text):
    """The types that a file defines, but those within functions; a nested one has the name of its class before it."""
    code, found, open_braces, start = code_of(text), [], [], 0
    for m in re.finditer(r"[{};]", code):
        if m[0] == "{":
            head = code[start:m.start()].strip()
            named = head_of_type.search(head)
            if re.search(r"\bnamespace\b", head):
                open_braces.append(("namespace", "", 0))
            elif named and "(" not in head[:named.start()]:
                open_braces.append(("type", named[1] + (named[2] or ""), code.count("\n", 0, m.start()) + 1))
            else:
                open_braces.append(("block", "", 0))
        elif m[0] == "}" and open_braces:
            kind, name, line = open_braces.pop()
            if kind == "type" and all(k != "block" for k, _, _ in open_braces):
                around = [n for k, n, _ in open_braces if k == "type"]
                found.append(Type("::".join(around + [name]), line, code.count("\n", 0, m.start()) + 1))
        start = m.end()
    return found


def lines_with(rule, text):
    return [text.count("\n", 0, m.start()) + 1 for m in rule.finditer(text)]


def complaints(files):
    """What is wrong; files: path below lib -> text."""
    rooms, beginnings, long_ones = collections.defaultdict(list), collections.Counter(), {}
    for path, text in files.items():
        for rule, wrong in ((silent_catch, "a catch without a statement (exact/tried.hpp)"),
                            (compared_texts, "values are compared as texts"),
                            (swallowed_label, "a label within a line")):
            for line in lines_with(rule, text):
                yield f"lib/{path}:{line}: {wrong}"
        beginnings.update(m[1] for m in beginning.finditer(text))
        room = path.split("/")[0]
        for t in types_of(text):
            rooms[room, t.name].append(f"lib/{path}:{t.first}")
            length = t.last - t.first + 1
            if length > most_lines and room not in not_counted:
                long_ones[f"{path} {t.name}"] = length
    for (room, name), places in sorted(rooms.items()):
        if len(places) > 1:
            yield f"{name} is defined more than once in lib/{room}: {', '.join(places)}"
    for word, most in most_beginnings.items():
        if beginnings[word] > most:
            yield f"{beginnings[word]} comments begin with '{word}', which were {most}: begin with the noun"
    for name, length in long_ones.items():
        if length > long_classes.get(name, most_lines):
            yield f"lib/{name} has {length} lines: at most {long_classes.get(name, most_lines)}"
    for name in long_classes.keys() - long_ones.keys():
        yield f"lib/{name} is no long class any more: take it off the list"


def traps():
    """Each rule sees what it is made for, and nothing beside it."""
    def seen(*texts, room="room"):
        files = {f"{room}/{i}.cpp": text for i, text in enumerate(texts)}
        return [c for c in complaints(files) if not c.endswith("off the list")]
    begins = {word: most + 1 for word, most in most_beginnings.items()}
    lengthy = "class C {\n" + "int f();\n" * (most_lines - 1) + "};\n"
    wrong = [["try { f(); } catch (const E&) { // nothing\n}"], ["try { f(); } catch (const E&) {}"],
             ["bool b = to_string(a.p) == to_string(b.p);"], ["bool b = to_string(f(a)) != to_string(b);"],
             ["/// Errors, positive degree Cost  much"], ["struct A {};", "namespace n { class A : B {}; }"],
             ["template <class T> struct A : B<T> { int x; }; enum class A { x };"],
             ["struct A { struct B {}; };", "struct A::B {};"], [lengthy],
             *(["// " + word + " it\n" + ("/// " + word + " the\n") * begins[word]] for word in begins)]
    right = [["try { f(); } catch (const E&) {\n  return; // nothing\n}"], ['bool b = to_string(a) == "x";'],
             ["/// Errors  E   Cost  much", "/// It is.   Cost  much"],
             ["struct A; struct A { struct Kind {}; }; struct B { enum class Kind { x }; };"],
             ["void f() { struct Local {}; } void g() { struct Local {}; }"],
             ["// struct A {};\nstruct A {}; const char* x = \"struct A {};\";"],
             [lengthy.replace("int f();\n", "", 1)], ["// Whosever, Office, where\n"]]
    for texts in wrong:
        assert seen(*texts), texts
    for texts in right:
        assert not seen(*texts), (texts, seen(*texts))
    assert not seen(lengthy, room=not_counted[0])


def main(root):
    traps()
    files = {}
    for folder, _, names in os.walk(os.path.join(root, "lib")):
        for name in names:
            if name.endswith((".hpp", ".cpp", ".inl")):
                path = os.path.join(folder, name)
                with open(path, encoding="utf-8") as text:
                    files[os.path.relpath(path, os.path.join(root, "lib"))] = text.read()
    wrong = list(complaints(files))
    with open(os.path.join(root, ".clang-format"), encoding="utf-8") as style:
        if "ReflowComments: false" not in style.read():
            wrong.append(".clang-format: tables in comments are written anew without ReflowComments: false")
    print("\n".join(wrong))
    return bool(wrong)


sys.exit(main(sys.argv[1]))
