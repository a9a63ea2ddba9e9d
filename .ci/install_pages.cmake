# Installs the manual page, the completions and what Debian wants to know. `program` is mien as it was
# built, `pages` a folder for what it prints.
get_filename_component(source "${CMAKE_CURRENT_LIST_DIR}/.." ABSOLUTE)

# What `program` prints, as the file `name`.
function(print_page name)
  execute_process(COMMAND "${program}" ${ARGN} OUTPUT_FILE "${pages}/${name}" COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# As Debian compresses: as small as can be, and the same bytes each time.
function(compress file name)
  execute_process(COMMAND gzip -9nc "${file}" OUTPUT_FILE "${pages}/${name}.gz" COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(MAKE_DIRECTORY "${pages}/bash" "${pages}/zsh")
print_page(mien.1 man)
print_page(bash/mien completion bash)
print_page(zsh/_mien completion zsh)
compress("${pages}/mien.1" mien.1)
compress("${source}/CHANGELOG.md" changelog)
compress("${pages}/changelog.Debian" changelog.Debian)

set(share "${CMAKE_INSTALL_PREFIX}/share")
file(INSTALL "${pages}/mien.1.gz" DESTINATION "${share}/man/man1")
file(INSTALL "${pages}/bash/mien" DESTINATION "${share}/bash-completion/completions")
file(INSTALL "${pages}/zsh/_mien" DESTINATION "${share}/zsh/vendor-completions")
file(INSTALL "${pages}/changelog.gz" "${pages}/changelog.Debian.gz" "${source}/.ci/copyright"
  DESTINATION "${share}/doc/mien")
