"""The Python module kovacic, built by CMake (C++20, and the libraries of tools/packages.txt, have to be there).

    /usr/bin/python3 -m pip wheel --no-build-isolation --no-deps .

in a tree that tools/packaging/source made.  CMAKE_ARGS holds more arguments for cmake, CMAKE_BUILD_PARALLEL_LEVEL how
many compilers run at once.  With KOVACIC_VENDOR=1 the shared libraries go into the wheel, beside the module, which finds
them there wherever it is installed: for machines that lack FLINT, GiNaC and Z3 and have no older C and C++ library.
"""

import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent
PROJECT = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
VENDOR = os.environ.get("KOVACIC_VENDOR", "") not in ("", "0")
# What belongs to the machine, as for every wheel: its own C and C++ library.
SYSTEM = re.compile(r"(ld-linux.*|lib(c|m|dl|rt|pthread|stdc\+\+|gcc_s))\.so")


class Build(build_ext):
    def build_extension(self, extension):
        build = pathlib.Path(self.build_temp).resolve() / "cmake"
        linker = "-s"
        options = ["-DCMAKE_BUILD_TYPE=Release", "-DBUILD_TESTING=OFF", f"-DKOV_PYTHON={sys.executable}"]
        if VENDOR:
            # An RPATH, which the libraries of the libraries are searched by too; a RUNPATH is not.
            linker += " -Wl,--disable-new-dtags"
            options += ["-DCMAKE_BUILD_WITH_INSTALL_RPATH=ON", "-DCMAKE_INSTALL_RPATH=$ORIGIN/libs"]
        options += [f"-DCMAKE_MODULE_LINKER_FLAGS={linker}", *shlex.split(os.environ.get("CMAKE_ARGS", ""))]
        subprocess.run(["cmake", "-S", ROOT, "-B", build, "-G", "Ninja", *options], check=True)
        subprocess.run(["cmake", "--build", build, "--target", "python"], check=True)
        [module] = (build / "python/kovacic").glob("_core*.so")
        target = pathlib.Path(self.get_ext_fullpath(extension.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(module, target)
        if VENDOR:
            self.vendor(target)

    def vendor(self, module):
        """Every library that the module loads, beside it, under the name by which it is asked for."""
        libraries = module.parent / "libs"
        shutil.rmtree(libraries, ignore_errors=True)
        libraries.mkdir()
        said = subprocess.run(["ldd", module], check=True, capture_output=True, text=True).stdout
        for name, path in re.findall(r"^\s*(\S+) => (/\S+)", said, re.M):
            if not SYSTEM.match(name):
                shutil.copy(path, libraries / name)


setup(
    name="kovacic",
    version=re.search(r"^project\(kovacic VERSION (\S+)", PROJECT, re.M)[1],
    description=re.search(r'DESCRIPTION "([^"]*)"', PROJECT)[1],
    license="GPL-3.0-or-later",
    python_requires=">=3.11",
    extras_require={"sympy": ["sympy"], "numpy": ["numpy"]},
    packages=["kovacic"],
    package_dir={"kovacic": "tools/python_module/kovacic"},
    package_data={"kovacic": ["*.pyi", "py.typed"]},
    ext_modules=[Extension("kovacic._core", [])],
    cmdclass={"build_ext": Build},
    zip_safe=False,
)
