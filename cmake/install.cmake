# What `cmake --install` puts where, in three components: the program with its manual, completion, cases and docs; the
# layers as static libraries for find_package(tanktread); the Python package.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(TT_PYTHON_DIR lib/python3/dist-packages CACHE STRING "Where the Python package goes, below the prefix")
set(TT_ZSH_DIR ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions CACHE STRING "Where zsh looks for completions, below the prefix")
find_program(GZIP gzip REQUIRED)

# --- the program
# The manual is written by the program, from what its help and its reference of keys say.
set(manual ${CMAKE_BINARY_DIR}/manual)
add_custom_command(OUTPUT ${manual}/tanktread.1.gz DEPENDS tanktread VERBATIM
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${manual}
  COMMAND tanktread manual ${manual}
  COMMAND sh -c "\"$1\" -9n \"$2\"/*" sh ${GZIP} ${manual}
  COMMENT "Writing the manual")
add_custom_target(tt_manual ALL DEPENDS ${manual}/tanktread.1.gz)

set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME program)
install(TARGETS tanktread)
foreach(section 1 5)
  install(DIRECTORY ${manual}/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man${section} FILES_MATCHING PATTERN "*.${section}.gz")
endforeach()
install(FILES tools/completion/tanktread.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME tanktread)
install(FILES tools/completion/_tanktread DESTINATION ${TT_ZSH_DIR})
install(DIRECTORY cases DESTINATION ${CMAKE_INSTALL_DATADIR}/tanktread)
install(FILES README.md CHANGELOG.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR})

# --- the layers, all but the program's own
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME development)
set(library_layers ${all_layers})
list(REMOVE_ITEM library_layers tt_app)
add_library(tt_library INTERFACE)
target_link_libraries(tt_library INTERFACE ${library_layers})
set_target_properties(tt_library PROPERTIES EXPORT_NAME tanktread)
foreach(layer IN LISTS library_layers)
  string(REPLACE tt_ "" name ${layer})
  set_target_properties(${layer} PROPERTIES EXPORT_NAME ${name})
  install(DIRECTORY src/${name} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/tanktread FILES_MATCHING PATTERN "*.hpp" PATTERN assets EXCLUDE)
endforeach()
install(FILES ${CMAKE_BINARY_DIR}/generated/base/version.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/tanktread/base)
install(TARGETS tt_library ${library_layers} EXPORT tanktread ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}/tanktread)
set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/tanktread)
install(EXPORT tanktread NAMESPACE tanktread:: FILE tanktread-targets.cmake DESTINATION ${config_dir})
configure_package_config_file(cmake/tanktread-config.cmake.in ${CMAKE_BINARY_DIR}/tanktread-config.cmake
                              INSTALL_DESTINATION ${config_dir} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/tanktread-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/tanktread-config.cmake ${CMAKE_BINARY_DIR}/tanktread-config-version.cmake DESTINATION ${config_dir})

# --- Python
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME python)
install(DIRECTORY python/tanktread DESTINATION ${TT_PYTHON_DIR} FILES_MATCHING PATTERN "*.py" PATTERN __pycache__ EXCLUDE)
install(FILES python/example.py DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/python3-tanktread/examples)
