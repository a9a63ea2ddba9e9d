# cmake -DSOURCE=<source tree> -DOUTPUT=<header> -P code_identity.cmake
# Hashes the sources that artifacts depend on. Paths relative to the tree go in, so that the place of the tree
# does not matter. Beside the header stands <header>.sources: a line a hash and source, for whoever wants to
# know what is in which.
set(listing "")

# The hash of all C++ sources in some folders (with what lies below them) or of single files.
function(hash_sources name)
  set(sources "")
  foreach(place IN LISTS ARGN)
    if(IS_DIRECTORY "${SOURCE}/${place}")
      file(GLOB_RECURSE found RELATIVE "${SOURCE}" "${SOURCE}/${place}/*.cpp" "${SOURCE}/${place}/*.h")
    else()
      file(GLOB found RELATIVE "${SOURCE}" "${SOURCE}/${place}")
    endif()
    if(NOT found)
      message(FATAL_ERROR "${CMAKE_CURRENT_LIST_FILE}: ${place} holds no source; what is in the hash \"${name}\"?")
    endif()
    list(APPEND sources ${found})
  endforeach()
  list(FILTER sources EXCLUDE REGEX "^pipeline/(commands|production/archive)/")
  list(SORT sources)
  list(REMOVE_DUPLICATES sources)
  set(text "")
  foreach(source IN LISTS sources)
    file(SHA256 "${SOURCE}/${source}" hash)
    string(APPEND text "${source} ${hash}\n")
    string(APPEND listing "${name} ${source}\n")
  endforeach()
  string(SHA256 hash "${text}")
  set(${name} ${hash} PARENT_SCOPE)
  set(listing "${listing}" PARENT_SCOPE)
endfunction()

hash_sources(motion motion)
# Pictures: also what reads looks and sets, and what a picture's size is.
hash_sources(film motion render scenes pipeline/base/documents pipeline/base/reading pipeline/manifest/look pipeline/base/drawing pipeline/production/film
             pipeline/manifest/output.h pipeline/manifest/output.cpp)
hash_sources(pipeline pipeline)
file(WRITE ${OUTPUT}.new
"// Generated from the sources' contents.
#pragma once
inline constexpr char motion_code_hash[] = \"${motion}\";
inline constexpr char film_code_hash[] = \"${film}\";
inline constexpr char pipeline_code_hash[] = \"${pipeline}\";
")
file(COPY_FILE ${OUTPUT}.new ${OUTPUT} ONLY_IF_DIFFERENT)
file(REMOVE ${OUTPUT}.new)
file(WRITE ${OUTPUT}.sources "${listing}")
