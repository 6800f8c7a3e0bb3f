#!/usr/bin/python3
"""The pages of the interfaces: C++ from the headers (doxygen, breathe), Python from the stubs and the module's own help.

usage: interfaces.py ROOT DIRECTORY
       interfaces.py --filter HEADER      what doxygen reads instead of a header
"""

import ast
import inspect
import pathlib
import re
import subprocess
import sys

DOXYFILE = """
PROJECT_NAME = kovacic
INPUT = "{root}/lib"
FILE_PATTERNS = *.hpp
RECURSIVE = YES
EXCLUDE_SYMBOLS = detail *::detail
INPUT_FILTER = "/usr/bin/python3 {me} --filter"
OUTPUT_DIRECTORY = "{out}"
GENERATE_XML = YES
XML_PROGRAMLISTING = NO
GENERATE_HTML = NO
GENERATE_LATEX = NO
QUIET = YES
WARNINGS = NO
WARN_IF_UNDOCUMENTED = NO
EXTRACT_ALL = YES
HIDE_UNDOC_MEMBERS = NO
ENABLE_PREPROCESSING = YES
MACRO_EXPANSION = YES
EXPAND_ONLY_PREDEF = YES
PREDEFINED = "KOV_EXPECT(x)="
STRIP_FROM_PATH = "{root}"
SORT_MEMBER_DOCS = NO
"""
WORDS = re.compile(r"^(\s*///) (Example|Given|Errors?|Cost|Requires|Shapes?|Source|Throws|Returns) +(.*)$")


def filtered(text):
    """Examples as code, and the other fixed words of our headers as paragraphs of their own."""
    lines = []
    for line in text.split("\n"):
        found = WORDS.match(line)
        if found and found.group(2) in ("Example", "Given"):
            mark, _, code = found.groups()
            lines.append(f"{mark} \\code{{.cpp}}\n{mark} {code}\n{mark} \\endcode")
        elif found:
            lines.append(f"{found.group(1)}\n{found.group(1)} **{found.group(2)}** {found.group(3)}")
        else:
            lines.append(line)
    return "\n".join(lines)


def about(header):
    """The comment at the top of a header, as text for Markdown."""
    lines = []
    for line in header.read_text(encoding="utf-8").split("\n"):
        if line.startswith("//"):
            lines.append(line[3:])
        elif lines:
            break
    paragraphs = "\n".join(lines).split("\n\n")
    return "\n\n".join(f"```\n{p}\n```" if p.startswith((" ", "\t")) else escaped(p) for p in paragraphs)


def escaped(text):
    """Plain text for Markdown; `code` stays code."""
    parts = text.split("`")
    if len(parts) % 2 == 0:
        parts = [text.replace("`", "\\`")]
    return "`".join(part if i % 2 else re.sub(r"([\\*_<>\[\]|$])", r"\\\1", part) for i, part in enumerate(parts))


def rooms(root):
    """The rooms in the order of lib/CMakeLists.txt, each with the comment above it, if it has one."""
    listing = (root / "lib/CMakeLists.txt").read_text(encoding="utf-8")
    return re.findall(r"^kov_room\((\w+)", listing, re.M)


def write_cpp(root, out):
    xml = out.parent.parent / "doxygen"
    xml.mkdir(parents=True, exist_ok=True)
    doxyfile = DOXYFILE.format(root=root, me=pathlib.Path(__file__).resolve(), out=xml)
    subprocess.run(["doxygen", "-"], input=doxyfile, text=True, check=True, stdout=subprocess.DEVNULL)
    (out / "cpp").mkdir(parents=True, exist_ok=True)
    index = ["# C++\n", "One page for each directory of `lib/`, in the order in which they build on each other. A program uses",
             "`find_package(kovacic)` or `pkg-config kovacic` and includes `directory/name.hpp`: [](../../guide/proof-scripts.md).\n",
             ":::{toctree}\n:maxdepth: 1\n"]
    for room in rooms(root):
        page = [f"# {room}\n"]
        for header in sorted((root / "lib" / room).rglob("*.hpp")):
            name = header.relative_to(root / "lib")
            page += [f"## {name}\n", about(header), "\n```{eval-rst}", f".. doxygenfile:: lib/{name}", "   :project: kovacic",
                     "   :sections: briefdescription detaileddescription innerclass func enum typedef var public*", "```\n"]
        (out / "cpp" / f"{room}.md").write_text("\n".join(page), encoding="utf-8")
        index.append(room)
    (out / "cpp" / "index.md").write_text("\n".join([*index, ":::\n"]), encoding="utf-8")


def write_python(root, out):
    sys.path.append(str(root / "build/release/python"))
    import kovacic
    stubs = ast.parse((root / "tools/python_module/kovacic/__init__.pyi").read_text(encoding="utf-8"))
    page = ["# Python\n", "What `import kovacic` gives, with its types. Examples: [](../guide/python.md).\n"]
    functions = [node for node in stubs.body if isinstance(node, ast.FunctionDef)]
    classes = [node for node in stubs.body if isinstance(node, ast.ClassDef)]
    page += ["## Functions\n", *(function(node, getattr(kovacic, node.name)) for node in functions)]
    page += ["## Values\n", *(a_class(node, getattr(kovacic, node.name)) for node in classes)]
    (out / "python.md").write_text("\n".join(page), encoding="utf-8")


def documented(thing):
    text = inspect.getdoc(thing) or ""
    return "\n\n".join(f"```\n{p}\n```" if ">>>" in p or p.startswith("  ") else escaped(p) for p in text.split("\n\n"))


def signature(node, skip=0):
    arguments = ast.parse(ast.unparse(node)).body[0].args
    arguments.args = arguments.args[skip:]
    returns = f" -> {ast.unparse(node.returns)}" if node.returns else ""
    return f"{node.name}({ast.unparse(arguments)}){returns}"


def function(node, thing):
    return f"::::{{py:function}} {signature(node)}\n:noindex:\n\n{documented(thing)}\n::::\n"


def a_class(node, thing):
    lines = [f"::::{{py:class}} {node.name}\n:noindex:\n", documented(thing) if thing.__doc__ else "", ""]
    shown = []
    for part in node.body:
        if isinstance(part, ast.AnnAssign):
            shown.append(f"{ast.unparse(part.target)}: {ast.unparse(part.annotation)}")
        elif isinstance(part, ast.FunctionDef) and not part.name.startswith("_"):
            static = any(isinstance(d, ast.Name) and d.id in ("staticmethod", "property") for d in part.decorator_list)
            shown.append(signature(part, 1) if not static else ast.unparse(part).split("\n")[-1].removesuffix(": ..."))
        elif isinstance(part, ast.Assign):
            shown.append(ast.unparse(part.targets[0]))
    if shown:
        lines.append("```python\n" + "\n".join(shown) + "\n```")
    return "\n".join([*lines, "::::\n"])


def main():
    if sys.argv[1] == "--filter":
        sys.stdout.write(filtered(pathlib.Path(sys.argv[2]).read_text(encoding="utf-8")))
        return
    root, out = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    out.mkdir(parents=True, exist_ok=True)
    write_cpp(root, out)
    write_python(root, out)


if __name__ == "__main__":
    main()
