# What `cmake --install` puts where, and the Debian package that `cpack` (or `./mien package`) makes of it.
# The program finds its manifests in ../share/mien beside its own folder, whatever the prefix.
install(DIRECTORY manifests/ DESTINATION share/mien/manifests
  FILES_MATCHING PATTERN "*.yaml" PATTERN "*.json" PATTERN "*.csv" PATTERN "*.wav"
  PATTERN "pictures" EXCLUDE PATTERN "tutorials" EXCLUDE)
install(DIRECTORY scenes/sets/ DESTINATION share/mien/scenes/sets
  FILES_MATCHING PATTERN "*.yaml" PATTERN "*.json")
# The pages, where they have been built (./mien package does): who installs the package needs no Node.js.
foreach(page lab matching questionnaire regress studio walk)
  install(DIRECTORY ${CMAKE_BINARY_DIR}/pages/${page} DESTINATION share/mien/pages OPTIONAL)
endforeach()
install(FILES ${CMAKE_BINARY_DIR}/pages/live_core/live_core.wasm DESTINATION share/mien/pages/live_core OPTIONAL)

# The manual page and the completions are what the program says of itself.
install(CODE "set(program \"$<TARGET_FILE:mien>\")\nset(pages \"${CMAKE_BINARY_DIR}/pages\")")
install(SCRIPT .ci/install_pages.cmake)

# Debian 12 and 13 have other libraries: a package a release, the older one's sorting first.
cmake_host_system_information(RESULT system QUERY DISTRIB_ID)
cmake_host_system_information(RESULT system_version QUERY DISTRIB_VERSION_ID)
string(REPLACE "debian" "deb" system "${system}")
set(CPACK_DEBIAN_PACKAGE_RELEASE 1~${system}${system_version})

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR}/package)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE
  GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PACKAGE_CONTACT "mien maintainers <maintainers@mien.invalid>")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Sheets are set in this font, English and Japanese; with another one they are other bytes.
set(CPACK_DEBIAN_PACKAGE_DEPENDS fonts-noto-cjk)
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"mien makes the videos of studies of how people see human motion. A study is
described in a YAML file: example motions, the adjectives that a new motion
should answer to, how it is to be shown. mien synthesizes the motions,
ray-traces them, encodes and checks the videos, draws comparison sheets, and
writes down exactly what it did. The same file gives the same bytes each time.

It also renders, measures, checks, compares, modifies and converts any human
motion in BVH, Acclaim or glTF files, and analyses answers of rating studies.")

find_program(DATE date)
execute_process(COMMAND ${DATE} -u -R -d ${MIEN_RELEASE_DATE} OUTPUT_VARIABLE MIEN_DEBIAN_DATE
  OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
configure_file(.ci/changelog.Debian.in pages/changelog.Debian @ONLY)
include(CPack)
