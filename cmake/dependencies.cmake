# What the build needs, and the Debian package that has it. What is absent is told in one message.
set(TT_MISSING_PACKAGES)

# A package that brings a CMake configuration or has a Find module.
macro(tt_find name debian_package)
  find_package(${name} QUIET ${ARGN})
  if(NOT ${name}_FOUND)
    list(APPEND TT_MISSING_PACKAGES ${debian_package})
  endif()
endmacro()

# A header of a library without one.
macro(tt_find_header header debian_package)
  string(MAKE_C_IDENTIFIER TT_HEADER_${header} variable)
  find_path(${variable} ${header})
  mark_as_advanced(${variable})
  if(NOT ${variable})
    list(APPEND TT_MISSING_PACKAGES ${debian_package})
  endif()
endmacro()

find_package(Threads REQUIRED)
tt_find(fmt libfmt-dev)
tt_find(HDF5 libhdf5-dev COMPONENTS C)
tt_find(ZLIB zlib1g-dev)
tt_find(nlohmann_json nlohmann-json3-dev)
tt_find(CLI11 libcli11-dev)
tt_find(Eigen3 libeigen3-dev)
tt_find_header(toml++/toml.h libtomlplusplus-dev)
tt_find_header(xxhash.h libxxhash-dev)
if(TT_TESTS)
  tt_find(GTest libgtest-dev)
  tt_find_header(rapidcheck.h librapidcheck-dev)
endif()
if(TT_BENCH)
  tt_find(benchmark libbenchmark-dev)
endif()

if(TT_MISSING_PACKAGES)
  list(JOIN TT_MISSING_PACKAGES " " TT_MISSING_PACKAGES)
  message(FATAL_ERROR "These development packages are absent:\n"
    "  apt-get install ${TT_MISSING_PACKAGES}\n"
    "tools/install build test installs all that the program and its tests need.")
endif()
