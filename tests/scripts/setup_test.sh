#!/usr/bin/env bash
# tools/setup and tools/run on a project of one file: two calls at once, a rebuild under a running
# program, a tree that cannot be written, a missing package without root, a build that fails.
#   setup_test.sh SOURCE_DIRECTORY
set -uo pipefail
source_directory=$1
tree=$(mktemp -d)
trap 'chmod -R u+w "$tree"; rm -rf "$tree"' EXIT
failures=0

check() { # check TEXT CONDITION...
  local text=$1
  shift
  if "$@"; then echo "ok  $text"; else
    echo "FAILED  $text"
    tail -n 20 "$tree"/*.err
    failures=$((failures + 1))
  fi
}
says() { grep -q -- "$2" "$tree/$1"; }
# As somebody who is not root; as root itself where that cannot be tried.
as_nobody() {
  if ((EUID == 0)); then setpriv --reuid=65534 --regid=65534 --clear-groups "$@"; else "$@"; fi
}

fresh_tree() {
  chmod -R u+w "$tree" && rm -rf "${tree:?}"/*
  chmod 755 "$tree"
  mkdir -p "$tree/tools"
  cp "$source_directory"/tools/{setup,run} "$tree/tools"
  echo "bash   always there" >"$tree/tools/packages.txt"
  cat >"$tree/CMakePresets.json" <<'END'
{"version": 6, "configurePresets": [{"name": "release", "generator": "Ninja", "binaryDir": "${sourceDir}/build/release"}]}
END
  cat >"$tree/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.20)
project(tiny LANGUAGES C)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tools)
add_executable(kovacic main.c)
add_executable(kovacic-core main.c)
END
  program 1
}
program() { printf '#include <stdio.h>\n#include <unistd.h>\nint main(int c, char** v) { (void)v; if (c > 1) sleep(2); puts("answer %s"); return 0; }\n' "$1" >"$tree/main.c"; }
run() { # run NAME ARGS...: output in NAME.out, NAME.err, exit code in NAME.exit
  local name=$1
  shift
  "$tree/tools/run" "$@" >"$tree/$name.out" 2>"$tree/$name.err"
  echo $? >"$tree/$name.exit"
}

fresh_tree
for i in 1 2 3; do run "first$i" & done
wait
for i in 1 2 3; do check "three at once on a fresh tree: $i" says "first$i.out" 'answer 1'; done
check "the stages are shown" grep -q '2/3 configuring' "$tree"/first{1,2,3}.err
check "with an estimate" grep -q '3/3 building .* steps (about .* s; less' "$tree"/first{1,2,3}.err
check "and what is left" grep -q '100 % (. of ., about .* left)' "$tree"/first{1,2,3}.err
check "only the core" test ! -e "$tree/build/release/tools/kovacic"
check "and a log" test -s "$tree/build/setup.log"
run second
check "nothing to do is not worth a word" test ! -s "$tree/second.err"

run long wait &
sleep 1
program 2
run rebuilt &
run beside &
wait
check "a rebuild under a running program" says rebuilt.out 'answer 2'
check "and beside another one" says beside.out 'answer 2'
check "the running one ends" says long.out answer

echo 'no C' >"$tree/main.c"
run broken
check "a build that fails ends in 2" says broken.exit '^2$'
check "names its log" says broken.err "whole log is in $tree/build/setup.log"
check "and shows the error" says broken.err 'error:'

program 3
run third
chmod -R a+rX,a-w "$tree/build" "$tree/tools" "$tree/main.c"
as_nobody "$tree/tools/run" >/tmp/setup-test-$$.out 2>&1
check "a finished build in a read-only tree runs" grep -q 'answer 3' /tmp/setup-test-$$.out
rm -f /tmp/setup-test-$$.out

fresh_tree
printf '[tests]\nno-such-package-kovacic  a reason\n' >>"$tree/tools/packages.txt"
run core solve
check "packages of tests are not needed for an answer" says core.out 'answer 1'
printf '[pictures]\nbash  always there\n' >>"$tree/tools/packages.txt"
"$tree/tools/run" section >"$tree/section.out" 2>"$tree/section.err"
check "what simulates builds the whole program" test -x "$tree/build/release/tools/kovacic"
check "and answers" says section.out 'answer 1'

fresh_tree
echo "no-such-package-kovacic  a reason" >>"$tree/tools/packages.txt"
if ((EUID == 0)); then chown -R 65534 "$tree"; fi
as_nobody env PATH="$PATH" "$tree/tools/run" >"$tree/user.out" 2>"$tree/user.err"
check "without root the missing packages are named" says user.err 'missing: no-such-package-kovacic'
check "with the command" says user.err 'apt-get install --no-install-recommends no-such-package-kovacic'
check "and nothing is built" test ! -e "$tree/build/release"

echo "$failures failures"
((failures == 0))
