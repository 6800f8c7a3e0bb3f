#!/usr/bin/python3
"""The pages of the interfaces: C++ from the headers, Python from the stubs and the module's own help.

usage: interfaces.py ROOT DIRECTORY
"""

import ast
import inspect
import pathlib
import re
import sys

WORDS = re.compile(r"^(Example|Given|Errors?|Cost|Requires|Shapes?|Source|Throws|Returns) +(.*)$")
TYPES = re.compile(r"(template *<.*> *)?(struct|class|enum|union|using|namespace|concept)\b|#")
LITERAL = re.compile(r"""\"(\\.|[^"\\])*\"|'(\\.|[^'\\])'|//.*""")


def chunks(text):
    """(comment, code) of each declaration of a header, without the namespaces around them."""
    found, comment, code, depth, hidden = [], [], [], 0, 0

    def end():
        if code:
            found.append((list(comment), list(code)))
            comment.clear()
            code.clear()

    for line in text.split("\n"):
        opens = re.match(r"(inline )?namespace\b.*\{$", line)
        if hidden or re.match(r"namespace (\w+::)*detail\b|namespace \{", line):
            hidden += line.count("{") - line.count("}")
        elif opens or re.match(r"\}.*// namespace|#(pragma|include)|//( |$)", line) or not line.strip() and depth == 0:
            end()
            comment.clear()
        elif line.startswith("///") and depth == 0:
            end()
            comment.append(line[3:].removeprefix(" "))
        else:
            code.append(line)
            bare = LITERAL.sub("", line).rstrip()
            depth += sum(bare.count(c) for c in "{(") - sum(bare.count(c) for c in "})")
            if depth == 0 and bare.endswith((";", "}")):
                end()
    end()
    return found


def declaration(code):
    """The code of a type; of a function what stands before its body."""
    if TYPES.match(code[0]):
        return "\n".join(code)
    text = "\n".join(code).removeprefix("[[nodiscard]] ")
    head = re.match(r"(?s)(.*?\)(?: const)?(?: noexcept)?(?: -> [^{;]+?)?) *(\{|: [a-z_]+_?[({])", text)
    return head.group(1) + ";" if head else text


def commented(lines):
    """The comment of a declaration as Markdown: its examples as code, its fixed words in bold."""
    parts = []
    for line in lines:
        found = WORDS.match(line)
        if found and found.group(1) in ("Example", "Given"):
            if not parts or not parts[-1].startswith("```"):
                parts.append("```cpp")
            parts[-1] += "\n" + found.group(2)
        elif found:
            parts.append(f"**{found.group(1)}** {escaped(found.group(2))}")
        elif line.strip() and parts and not parts[-1].startswith("```"):
            parts[-1] += "\n" + escaped(line.strip())
        elif line.strip():
            parts.append(escaped(line.strip()))
    return "\n\n".join(part + "\n```" if part.startswith("```") else part for part in parts)


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
    """The directories of lib/ in the order of lib/CMakeLists.txt."""
    listing = (root / "lib/CMakeLists.txt").read_text(encoding="utf-8")
    return re.findall(r"^kov_room\((\w+)", listing, re.M)


def header_page(header, name):
    page = [f"## {name}\n", about(header), ""]
    for comment, code in chunks(header.read_text(encoding="utf-8")):
        page += ["```cpp", declaration(code), "```\n", commented(comment), ""]
    return page


def write_cpp(root, out):
    (out / "cpp").mkdir(parents=True, exist_ok=True)
    index = ["# C++\n", "One page for each directory of `lib/`, in the order in which they build on each other. A program uses",
             "`find_package(kovacic)` or `pkg-config kovacic` and includes `directory/name.hpp`: [](../../guide/proof-scripts.md).\n",
             ":::{toctree}\n:maxdepth: 1\n"]
    for room in rooms(root):
        page = [f"# {room}\n"]
        for header in sorted((root / "lib" / room).rglob("*.hpp")):
            page += header_page(header, header.relative_to(root / "lib"))
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
    root, out = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    out.mkdir(parents=True, exist_ok=True)
    write_cpp(root, out)
    write_python(root, out)


if __name__ == "__main__":
    main()
