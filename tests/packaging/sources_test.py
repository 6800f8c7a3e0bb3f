#!/usr/bin/env python3
"""The source trees for packagers are complete and say what the project says; nothing is built.

usage: sources_test.py SOURCE_DIR BUILD_DIR

BUILD_DIR is a configured build of this checkout: what CMake read and what the target `python` is made of is asked there.
The packages themselves are built by tools/packaging/test, which takes minutes.
"""

import importlib.machinery
import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT, BUILD = (pathlib.Path(path).resolve() for path in sys.argv[1:3])
PACKAGING = ROOT / "tools/packaging"
sys.dont_write_bytecode = True

# What a Debian package of tools/packages.txt [build] is called elsewhere; None: not needed there.
ELSEWHERE = {  # conda-forge (or the folder that build.sh compiles), Nixpkgs
    "g++": ("cxx", None), "cmake": ("cmake", "cmake"), "ninja-build": ("ninja", "ninja"), "ccache": (None, None),
    "libgmp-dev": ("gmp", "gmp"), "libmpfr-dev": ("mpfr", "mpfr"), "libflint-dev": ("libflint", "flint"),
    "libflint-arb-dev": ("arb", "arb"), "libantic-dev": ("antic", "antic"), "libcalcium-dev": ("calcium", "calcium"),
    "libcln-dev": ("cln", "cln"), "libginac-dev": ("ginac", "ginac"), "pkg-config": ("pkg-config", "pkg-config"),
    "libtomlplusplus-dev": ("tomlplusplus", "tomlplusplus"), "libz3-dev": ("z3", "z3"),
    "nlohmann-json3-dev": ("nlohmann_json", "nlohmann_json"), "nettle-dev": ("nettle", "nettle"),
    "libcli11-dev": ("cli11", "cli11"), "libfmt-dev": ("fmt", "fmt"), "python3-dev": ("python", "python"),
    "pybind11-dev": ("pybind11", "pybind11"),
}


def text(path):
    return path.read_text(encoding="utf-8")


def script():
    """tools/packaging/source as a module, for its lists."""
    loader = importlib.machinery.SourceFileLoader("source", str(PACKAGING / "source"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("source", loader))
    loader.exec_module(module)
    return module


def stanzas(control):
    """{package or "Source": {field: value}} of a debian/control."""
    found = {}
    for block in control.split("\n\n"):
        fields = dict(re.findall(r"^([A-Z][\w-]*): ((?:.*)(?:\n .*)*)", block, re.M))
        found[fields.get("Package", "Source")] = {key: " ".join(value.split()) for key, value in fields.items()}
    return found


def names(value):
    return [name.strip() for name in value.split(",") if name.strip()]


def cpack(component, field):
    """What CMake itself made of a call of kov_package."""
    found = re.search(rf'^set\(CPACK_DEBIAN_{component}_PACKAGE_{field} "(.*)"\)', text(BUILD / "CPackConfig.cmake"), re.M)
    return found[1] if found else ""


def of_this_checkout(paths):
    """Relative paths of those that lie in the checkout and not in a build."""
    inside = [os.path.relpath(path, ROOT) for path in paths if pathlib.Path(path).is_relative_to(ROOT)]
    return sorted({path for path in inside if not path.startswith("build/") and not (ROOT / path).is_relative_to(BUILD)})


class Trees(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.directory = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.directory.cleanup)
        cls.source = script()
        for kind in ("debian", "python"):
            out = pathlib.Path(cls.directory.name) / kind
            subprocess.run([PACKAGING / "source", kind, out], check=True)
            setattr(cls, kind, out)
        cls.version = re.search(r"VERSION (\S+)", text(ROOT / "CMakeLists.txt").split("project(", 1)[1])[1]
        cls.control = stanzas(text(cls.debian / "debian/control"))

    def test_versions(self):
        self.assertRegex(text(self.debian / "debian/changelog"), rf"^kovacic \({re.escape(self.version)}\) ")
        setup = text(self.python / "setup.py")
        pattern = re.search(r'version=re\.search\(r"(.*?)", PROJECT', setup)[1]
        self.assertEqual(re.search(pattern, text(self.python / "CMakeLists.txt"), re.M)[1], self.version)
        self.assertIn(f'set version = "{self.version}"', text(PACKAGING / "conda/meta.yaml"))

    def test_the_debian_tree_has_every_file(self):
        for path in self.source.files():
            self.assertEqual((self.debian / path).read_bytes(), (ROOT / path).read_bytes(), path)
            self.assertEqual(os.access(self.debian / path, os.X_OK), os.access(ROOT / path, os.X_OK), path)
        for path in ("control", "changelog", "copyright", "rules", "source/format", "kovacic.docs"):
            self.assertTrue((self.debian / "debian" / path).is_file(), path)
        self.assertFalse((self.debian / "debian/control.in").exists())
        self.assertTrue(os.access(self.debian / "debian/rules", os.X_OK))
        for path in text(self.debian / "debian/kovacic.docs").split():
            self.assertTrue((self.debian / path).is_file(), path)

    def test_debian_dependencies_are_those_of_cmake(self):
        self.assertEqual(set(self.control), {"Source", "kovacic", "python3-kovacic"})
        for component in ("COMMAND", "PYTHON"):
            package = self.control[cpack(component, "NAME")]
            own = [name for name in names(package["Depends"]) if not name.startswith("${")]
            self.assertEqual(own, [name for name in names(cpack(component, "DEPENDS")) if not name.startswith("python3 (")])
            for field in ("RECOMMENDS", "SUGGESTS"):
                self.assertEqual(package.get(field.capitalize(), ""), cpack(component, field))
        self.assertIn("kovacic", names(self.control["python3-kovacic"]["Depends"]))

    def test_what_debian_builds_with(self):
        needed = set(self.source.listed(["build"])) - {"g++", "ccache"} | {"python3-dev", "pybind11-dev"}
        needed |= {"debhelper-compat (= 13)", "dh-python", "python3-docutils", "python3-myst-parser"}
        self.assertEqual(set(names(self.control["Source"]["Build-Depends"])), needed)
        listed = {line.split()[0] for line in text(PACKAGING / "packages.txt").splitlines() if not line.startswith("#")}
        self.assertLessEqual({"python3-docutils", "python3-myst-parser"}, listed)

    def test_conda_and_nix_know_every_library(self):
        conda = set(re.findall(r"- \{\{ compiler\('(\w+)'\) \}\}|^ +- ([\w-]+)|folder: (\w+)", text(PACKAGING / "conda/meta.yaml"), re.M))
        conda = {name for found in conda for name in found if name}
        nix = set(re.findall(r"[\w-]+", text(PACKAGING / "nix/default.nix").split("nativeBuildInputs")[1].split("cmakeFlags")[0]))
        for package in self.source.listed(["build"]) + ["python3-dev", "pybind11-dev"]:
            self.assertIn(package, ELSEWHERE, f"what is {package} called by conda-forge and Nixpkgs?")
            for name, known in zip(ELSEWHERE[package], (conda, nix)):
                self.assertTrue(name is None or name in known, f"{package} as {name}")

    def test_docker_builds_the_debian_tree(self):
        docker = text(PACKAGING / "docker/Dockerfile")
        for step in ("tools/packaging/source debian", "apt-get build-dep", "dpkg-buildpackage"):
            self.assertIn(step, docker)

    def test_the_python_tree_has_what_cmake_reads(self):
        rule = re.search(r"^build build\.ninja[^:]*: RERUN_CMAKE [^|\n]*\|(.*(?:\$\n.*)*)", text(BUILD / "build.ninja"), re.M)
        read = of_this_checkout(str(BUILD / path) for path in rule[1].replace("$\n", "").split())
        read = [path for path in read if not path.startswith("tests/") and path != "CMakePresets.json"]
        self.assertIn("docs/references.bib", read)
        self.assertIn("tools/packaging/Packages.cmake", read)
        for path in read:
            self.assertTrue((self.python / path).is_file(), path)

    def test_the_python_tree_has_what_is_compiled(self):
        asked = subprocess.run(["ninja", "-C", BUILD, "-t", "inputs", "python"], capture_output=True, text=True)
        if asked.returncode:  # ninja before 1.11, or another generator
            self.skipTest(asked.stderr)
        inputs = [str(BUILD / line) for line in asked.stdout.splitlines()]
        for together in [path for path in inputs if "/Unity/" in path and path.endswith("xx")]:
            inputs += re.findall(r'^#include "(/.*)"$', text(pathlib.Path(together)), re.M)
        sources = of_this_checkout(inputs)
        if (BUILD / "python").exists():
            self.assertTrue(any(path.startswith("tools/python_module/core/") for path in sources))
            self.assertTrue(any(path.startswith("lib/exact/") for path in sources))
        for path in sources:
            self.assertTrue((self.python / path).is_file(), path)

    def test_the_python_tree_has_what_is_included(self):
        """Each #include "..." of a file of the checkout, in the files that are compiled and in their headers."""
        roots = ("lib", "tools", "tools/kovacic", "tools/python_module/core")
        known = {path for path in self.source.files() if path.endswith((".hpp", ".h", ".inl", ".cpp"))}
        for file in self.python.rglob("*"):
            if file.suffix not in (".cpp", ".hpp", ".h", ".c", ".inl") or "bench" in file.parts:
                continue
            where = file.relative_to(self.python).parent
            for included in re.findall(r'^\s*#\s*include "([^"]+)"', text(file), re.M):
                candidates = [os.path.normpath(root / pathlib.Path(included)) for root in (where, *map(pathlib.Path, roots))]
                meant = [path for path in candidates if path in known]
                self.assertTrue(meant, f"{file}: {included}")
                self.assertTrue(any((self.python / path).is_file() for path in meant), f"{file}: {included}")

    def test_the_python_package_is_whole(self):
        for path in (ROOT / "tools/python_module/kovacic").iterdir():
            if path.is_file():
                self.assertTrue((self.python / path.relative_to(ROOT)).is_file(), path)
                self.assertTrue(path.suffix in (".py", ".pyi") or path.name == "py.typed", f"package_data: {path}")
        for line in text(self.python / "MANIFEST.in").splitlines():
            for path in line.split()[1:]:
                self.assertTrue((self.python / path).exists(), path)

    def test_without_git(self):
        """From an unpacked archive, and where git is not installed, the same files."""
        with tempfile.TemporaryDirectory() as directory:
            archive, out = pathlib.Path(directory) / "archive", pathlib.Path(directory) / "out"
            for path in self.source.files():
                (archive / path).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy2(ROOT / path, archive / path)
            (archive / "build").mkdir()
            (archive / "build/generated").write_text("")
            empty = pathlib.Path(directory) / "empty"
            empty.mkdir()
            subprocess.run([sys.executable, archive / "tools/packaging/source", "python", out], check=True,
                           env={**os.environ, "PATH": str(empty)})
            made, expected = ({str(x.relative_to(tree)) for x in tree.rglob("*")} for tree in (out, self.python))
            self.assertEqual(made, expected)

    def test_nothing_is_overwritten(self):
        for out in (self.python, ROOT / "lib", ROOT):
            ran = subprocess.run([PACKAGING / "source", "python", out], capture_output=True, text=True)
            self.assertNotEqual(ran.returncode, 0, out)
            self.assertIn("tools/packaging/source:", ran.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
