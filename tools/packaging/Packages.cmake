# Debian packages by CPack, one for each component of cmake --install: tools/packaging/build makes them.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME kovacic)
set(CPACK_PACKAGE_CONTACT "The kovacic authors <authors@kovacic.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL command development python documentation)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION math)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
    WORLD_READ WORLD_EXECUTE)

# kov_package(command NAME kovacic SUMMARY ... DESCRIPTION ... [FIELD value]...): a field as dpkg calls it, e.g. DEPENDS
function(kov_package component)
  cmake_parse_arguments(P "" "NAME;SUMMARY;DESCRIPTION;SECTION;ARCHITECTURE;DEPENDS;RECOMMENDS;SUGGESTS;SHLIBDEPS" "" ${ARGN})
  string(TOUPPER ${component} key)
  set(CPACK_COMPONENT_${key}_DESCRIPTION "${P_SUMMARY}\n${P_DESCRIPTION}" PARENT_SCOPE)
  foreach(field SECTION ARCHITECTURE DEPENDS RECOMMENDS SUGGESTS SHLIBDEPS NAME)
    if(P_${field})
      set(CPACK_DEBIAN_${key}_PACKAGE_${field} "${P_${field}}" PARENT_SCOPE)
    endif()
  endforeach()
  install(FILES ${PROJECT_SOURCE_DIR}/tools/packaging/copyright ${CMAKE_BINARY_DIR}/packaging/changelog.gz
                ${CMAKE_BINARY_DIR}/packaging/changelog.Debian.gz
          DESTINATION share/doc/${P_NAME} COMPONENT ${component} OPTIONAL)
endfunction()

kov_package(command NAME kovacic SHLIBDEPS ON
  SUMMARY "The command kovacic, and a second checker of its certificates."
  DESCRIPTION "Decides the differential Galois group of y'' = r(z) y, and by the theorem
of Morales-Ruiz and Ramis whether a mechanical system is not integrable.
Arithmetic is exact; answers come with certificates that an independent
checker reads."
  DEPENDS "python3:any" RECOMMENDS gnuplot-nox SUGGESTS "kovacic-doc, python3-kovacic")
kov_package(development NAME libkovacic-dev SECTION libdevel
  SUMMARY "Headers and static libraries."
  DESCRIPTION "For proof scripts in C++: find_package(kovacic CONFIG), or pkg-config
kovacic."
  DEPENDS "libcalcium-dev, libantic-dev, libflint-arb-dev, libflint-dev, libmpfr-dev, libgmp-dev, libginac-dev, libz3-dev, nettle-dev, nlohmann-json3-dev"
  SUGGESTS "kovacic-doc, pkg-config")
kov_package(python NAME python3-kovacic SECTION python SHLIBDEPS ON
  SUMMARY "The Python module."
  DESCRIPTION "import kovacic: equations, systems and theorems from Python, SymPy and
notebooks."
  DEPENDS "kovacic, python3 (>= 3.11), python3 (<< 3.12)" RECOMMENDS "python3-sympy, python3-numpy"
  SUGGESTS "kovacic-doc, python3-distributed")
kov_package(documentation NAME kovacic-doc SECTION doc ARCHITECTURE all
  SUMMARY "Guide, theory, examples."
  DESCRIPTION "The guide by task, the theory with proofs, the interfaces of the C++ and
Python libraries, as a site that needs no network, and the systems of the
papers as examples." SUGGESTS "kovacic")
include(CPack)
