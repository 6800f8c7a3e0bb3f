"""What is written about the module is true: the guide, the notebook, the stubs, the example in its own help."""

import ast
import inspect
import doctest
import io
import json
import os
import pathlib
import re
import sys
import unittest

import kovacic

ROOT = pathlib.Path(os.environ["KOV_SOURCE"])
sys.path.insert(0, str(ROOT / "tools/site_source"))
sys.dont_write_bytecode = True
import notebooks  # noqa: E402


def has_sympy():
    try:
        import sympy  # noqa: F401
    except ImportError:
        return False
    return True


def run_examples(test, text, name):
    out = io.StringIO()
    runner = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE)
    example = doctest.DocTestParser().get_doctest(text, {"__name__": "guide"}, name, name, 0)
    test.assertGreater(len(example.examples), 0)
    runner.run(example, out=out.write)
    test.assertEqual(runner.summarize(verbose=False).failed, 0, out.getvalue())


class Documents(unittest.TestCase):
    def setUp(self):
        self.before = os.getcwd()
        os.chdir(ROOT)

    def tearDown(self):
        os.chdir(self.before)

    @unittest.skipUnless(has_sympy(), "needs SymPy")
    def test_guide(self):
        pages = 0
        for page in sorted(ROOT.glob("docs/guide/*.md")):
            blocks = re.findall(r"```python\n(.*?)```", page.read_text(encoding="utf-8"), re.S)
            if blocks:
                run_examples(self, "\n".join(blocks), page.name)
                pages += 1
        self.assertGreater(pages, 1)

    def test_help(self):
        run_examples(self, kovacic.__doc__, "kovacic")

    @unittest.skipUnless(has_sympy(), "needs SymPy")
    def test_notebook(self):
        notebook = json.loads((ROOT / "docs/guide/tutorial.ipynb").read_text(encoding="utf-8"))
        for cell in notebook["cells"]:
            if cell["cell_type"] == "code":
                self.assertEqual((cell["outputs"], cell["execution_count"]), ([], None), "stored output")
        cells, names = notebooks.cells(ROOT / "docs/guide/tutorial.ipynb")
        for source, printed, value in cells:
            if value is not None:
                self.assertNotIn("object at 0x", notebooks.shown(value), source)
        self.assertIs(names["report"].verdict, kovacic.VerdictKind.non_integrable)
        self.assertIn("integrable exactly for a = 0", names["theorem"].statement)  # it ends with a theorem
        self.assertIs(cells[-1][2], names["theorem"])

    def test_stubs(self):
        tree = ast.parse((pathlib.Path(kovacic.__file__).parent / "__init__.pyi").read_text(encoding="utf-8"))
        stubs = {node.name: node for node in tree.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
        self.assertEqual(sorted(stubs), sorted(kovacic.__all__))
        for name, node in stubs.items():
            if isinstance(node, ast.FunctionDef):
                code = inspect.unwrap(getattr(kovacic, name)).__code__
                arguments = [x.arg for x in node.args.args + node.args.kwonlyargs]
                count = code.co_argcount + code.co_kwonlyargcount
                self.assertEqual(arguments, list(code.co_varnames[:count]), name)
            elif issubclass(getattr(kovacic, name), BaseException):
                continue
            else:
                said = {x.target.id for x in node.body if isinstance(x, ast.AnnAssign)}
                said |= {x.name for x in node.body if isinstance(x, ast.FunctionDef)}
                said |= {t.id for x in node.body if isinstance(x, ast.Assign) for t in x.targets}
                here = getattr(kovacic, name)
                known = {x for x in vars(here) if not x.startswith("_")} | set(getattr(here, "__annotations__", ()))
                public = {x for x in said if not x.startswith("_")}
                if issubclass(here, __import__("enum").Enum):
                    known = set(here.__members__)
                self.assertEqual(public, known, name)


if __name__ == "__main__":
    unittest.main()
