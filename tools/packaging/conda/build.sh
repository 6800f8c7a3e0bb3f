#!/usr/bin/env bash
# What conda runs in the folder with the sources of meta.yaml.  PREFIX: where everything goes; PYTHON: for which the
# module is.  The three libraries that are compiled here are static, in a folder of their own.
set -euo pipefail
here=$PWD own=$PWD/own
export CPPFLAGS="-I$own/include ${CPPFLAGS:-}" CFLAGS="-fPIC -O2 ${CFLAGS:-}" CXXFLAGS="-fPIC -O2 ${CXXFLAGS:-}"
export LDFLAGS="-L$own/lib ${LDFLAGS:-}" PKG_CONFIG_PATH="$own/lib/pkgconfig:$PREFIX/lib/pkgconfig"
jobs=${CPU_COUNT:-2}

compile() { # compile FOLDER CONFIGURE_ARGUMENT...
  (cd "$1" && shift && ./configure --prefix="$own" "$@" && make -j"$jobs" && make install)
}
compile calcium --disable-shared --with-{gmp,mpfr,flint,arb,antic}="$PREFIX"
compile cln --disable-shared --with-gmp="$PREFIX"
compile ginac --disable-shared

options=(-DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=OFF "-DCMAKE_PREFIX_PATH=$own;$PREFIX" "-DKOV_PYTHON=$PYTHON")
cmake -S kovacic -B command -G Ninja "${options[@]}" -DCMAKE_INSTALL_PREFIX="$PREFIX"
cmake --build command --target kovacic -j "$jobs"
cmake --install command --component command

"$PYTHON" kovacic/tools/packaging/source python module
cd module
CMAKE_ARGS="-DCMAKE_PREFIX_PATH=$own;$PREFIX" CMAKE_BUILD_PARALLEL_LEVEL=$jobs \
  "$PYTHON" -m pip install --no-build-isolation --no-deps --prefix "$PREFIX" .
