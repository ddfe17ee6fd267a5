# `cpack -G DEB` makes three Debian packages of what cmake/install.cmake puts in place. tools/package builds and packs.
# Two builds of one commit give the same bytes: no file has a later time than the commit, or SOURCE_DATE_EPOCH.
set(TT_EPOCH $ENV{SOURCE_DATE_EPOCH})
if(NOT TT_EPOCH)
  execute_process(COMMAND git log -1 --format=%ct WORKING_DIRECTORY ${CMAKE_SOURCE_DIR}
                  OUTPUT_VARIABLE TT_EPOCH OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
if(NOT TT_EPOCH)
  file(TIMESTAMP ${CMAKE_SOURCE_DIR}/CHANGELOG.md TT_EPOCH %s UTC)
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The tanktread authors <tanktread@tanktread.invalid>" CACHE STRING "Who answers for the packages")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "red blood cells in two-dimensional flow")
set(CPACK_PACKAGE_VENDOR "the tanktread authors")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL program development python)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME tanktread)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "gnuplot-nox | gnuplot, fonts-dejavu-core, python3-tanktread")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "paraview, libtanktread-dev")
# What reads chip files (src/io/chips): DXF, GDSII, SVG and PNG.
string(APPEND CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS ", python3-shapely, python3-ezdxf, python3-gdspy, python3-svgelements, python3-pil, python3-contourpy")
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "Simulates plasma by the lattice Boltzmann method and cells as elastic membranes
that may stiffen as they are stretched, coupled by immersed boundaries. For
people who study flow in microvessels and microfluidic chips.
.
Runs stop and go on to the same bits, and end in one page with figures, a
player of the cells and checks of what to distrust.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libtanktread-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libfmt-dev, libhdf5-dev, libxxhash-dev, nlohmann-json3-dev, zlib1g-dev")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "The layers of tanktread, to compute with them in other programs: static
libraries, headers and a package for CMake.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-tanktread)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3, python3-h5py, python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS tanktread)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-matplotlib, python3-pandas, python3-xarray")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA "${CMAKE_SOURCE_DIR}/cmake/debian/postinst;${CMAKE_SOURCE_DIR}/cmake/debian/prerm")
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "The Python package: reads the results directories of tanktread as arrays with units, starts runs,
draws cells.")

# Each package has its copyright and its changelog.
file(READ LICENSE text)
string(REGEX REPLACE "^.*\n(Permission is hereby granted)" "\\1" text "${text}")
string(STRIP "${text}" text)
string(REPLACE "\n\n" "\n.\n" text "${text}")
string(REPLACE "\n" "\n " TT_LICENCE_TEXT " ${text}")
set(ENV{SOURCE_DATE_EPOCH} ${TT_EPOCH})
string(TIMESTAMP TT_DATE "%a, %d %b %Y %H:%M:%S +0000" UTC)
set(debian ${CMAKE_BINARY_DIR}/debian)
foreach(component program development python)
  string(TOUPPER ${component} upper)
  set(TT_PACKAGE ${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  configure_file(cmake/debian/changelog.in ${debian}/${TT_PACKAGE}/changelog.Debian @ONLY)
  configure_file(cmake/debian/copyright.in ${debian}/${TT_PACKAGE}/copyright @ONLY)
  execute_process(COMMAND ${GZIP} -9nf ${debian}/${TT_PACKAGE}/changelog.Debian)
  install(FILES ${debian}/${TT_PACKAGE}/changelog.Debian.gz ${debian}/${TT_PACKAGE}/copyright
          DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${TT_PACKAGE} COMPONENT ${component})
endforeach()
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/pack-time.cmake @ONLY CONTENT
     "if(NOT DEFINED ENV{SOURCE_DATE_EPOCH})\n  set(ENV{SOURCE_DATE_EPOCH} @TT_EPOCH@)\nendif()\n")
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_BINARY_DIR}/pack-time.cmake)
include(CPack)
