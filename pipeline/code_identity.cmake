# cmake -DSOURCE=<source tree> -DOUTPUT=<header> -P code_identity.cmake
# Hashes the sources that artifacts depend on. Paths relative to the tree go in, so that the place of the tree
# does not matter.
function(hash_sources variable)
  set(text "")
  foreach(pattern IN LISTS ARGN)
    file(GLOB sources RELATIVE "${SOURCE}" "${SOURCE}/${pattern}.cpp" "${SOURCE}/${pattern}.h")
    list(SORT sources)
    foreach(source IN LISTS sources)
      file(SHA256 "${SOURCE}/${source}" hash)
      string(APPEND text "${source} ${hash}\n")
    endforeach()
  endforeach()
  string(SHA256 hash "${text}")
  set(${variable} ${hash} PARENT_SCOPE)
endfunction()

hash_sources(motion motion/* motion/*/*)
hash_sources(film motion/* motion/*/* render/* scenes/* pipeline/film* pipeline/look* pipeline/set_file*
             pipeline/drawing*)
hash_sources(pipeline pipeline/*)
file(WRITE ${OUTPUT}.new
"// Generated from the sources' contents.
#pragma once
inline constexpr char motion_code_hash[] = \"${motion}\";
inline constexpr char film_code_hash[] = \"${film}\";
inline constexpr char pipeline_code_hash[] = \"${pipeline}\";
")
file(COPY_FILE ${OUTPUT}.new ${OUTPUT} ONLY_IF_DIFFERENT)
file(REMOVE ${OUTPUT}.new)
