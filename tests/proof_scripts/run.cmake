# Installs into SCRATCH, builds the proof scripts against it, and runs them.
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()
file(REMOVE_RECURSE ${SCRATCH})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${SCRATCH}/prefix)
run(${CMAKE_COMMAND} -S ${SOURCE} -B ${SCRATCH}/build -G Ninja -DCMAKE_BUILD_TYPE=Release
    -DCMAKE_PREFIX_PATH=${SCRATCH}/prefix -DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
run(${CMAKE_COMMAND} --build ${SCRATCH}/build)
run(${SCRATCH}/build/homogeneous)
# without CMake
find_program(PKG_CONFIG pkg-config REQUIRED)
set(ENV{PKG_CONFIG_PATH} ${SCRATCH}/prefix/lib/pkgconfig)
run(sh -c "ccache g++ -c ${SOURCE}/airy.cpp -o ${SCRATCH}/airy.o $(${PKG_CONFIG} --cflags kovacic)")
run(sh -c "g++ ${SCRATCH}/airy.o -o ${SCRATCH}/airy $(${PKG_CONFIG} --libs kovacic)")
run(${SCRATCH}/airy)
