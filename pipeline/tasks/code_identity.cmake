# cmake -DSOURCE=<source tree> -DOUTPUT=<header> -P code_identity.cmake
# Hashes the sources that can make an artifact: where its making begins, with all that this includes, however
# far. A header stands for the sources that define what it declares: the one of its name, or, of a source
# without a header of its name, any header beside it that the source includes. Paths relative to the tree go
# in, so that the place of the tree does not matter. Beside the header stands <header>.sources: a line a hash
# and source, for whoever wants to know what is in which.
cmake_policy(SET CMP0057 NEW)
set(listing "")
set(header "// Generated from the sources' contents.\n#pragma once\n")

# What a source includes of the tree, and the sources that a header stands for.
file(GLOB_RECURSE sources RELATIVE ${SOURCE} ${SOURCE}/motion/*.cpp ${SOURCE}/motion/*.h ${SOURCE}/render/*.cpp
  ${SOURCE}/render/*.h ${SOURCE}/scenes/*.cpp ${SOURCE}/scenes/*.h ${SOURCE}/pipeline/*.cpp ${SOURCE}/pipeline/*.h)
foreach(source IN LISTS sources)
  set(is_there_${source} TRUE)
endforeach()
foreach(source IN LISTS sources)
  file(STRINGS ${SOURCE}/${source} lines REGEX "^ *# *include *\"")
  list(TRANSFORM lines REPLACE "^[^\"]*\"([^\"]*)\".*$" "\\1")
  list(APPEND leads_to_${source} ${lines})
  if(NOT source MATCHES "\\.cpp$")
    continue()
  endif()
  string(REGEX REPLACE "cpp$" "h" own ${source})
  if(is_there_${own})
    list(APPEND leads_to_${own} ${source})
  else()
    get_filename_component(folder ${source} DIRECTORY)
    foreach(line IN LISTS lines)
      if(line MATCHES "^${folder}/[^/]*$")
        list(APPEND leads_to_${line} ${source})
      endif()
    endforeach()
  endif()
endforeach()

# hash_artifact(<name> <source>... [WITHOUT <module>...]): of what begins in these sources; without what lies in
# modules that cannot change it.
function(hash_artifact name)
  cmake_parse_arguments(ARG "" "" "WITHOUT" ${ARGN})
  set(waiting ${ARG_UNPARSED_ARGUMENTS})
  set(reached "")
  while(waiting)
    set(next "")
    foreach(source IN LISTS waiting)
      string(REGEX REPLACE "/.*$" "" module ${source})
      if(is_reached_${source} OR NOT is_there_${source} OR module IN_LIST ARG_WITHOUT)
        continue()
      endif()
      set(is_reached_${source} TRUE)
      list(APPEND reached ${source})
      list(APPEND next ${leads_to_${source}})
    endforeach()
    set(waiting ${next})
  endwhile()
  foreach(source IN LISTS ARG_UNPARSED_ARGUMENTS)
    if(NOT is_there_${source})
      message(FATAL_ERROR "${CMAKE_CURRENT_LIST_FILE}: there is no ${source}; where does the making of \"${name}\" begin?")
    endif()
  endforeach()
  list(SORT reached)
  set(text "")
  foreach(source IN LISTS reached)
    file(SHA256 ${SOURCE}/${source} hash)
    string(APPEND text "${source} ${hash}\n")
    string(APPEND listing "${name} ${source}\n")
  endforeach()
  string(SHA256 hash "${text}")
  set(header "${header}inline constexpr char ${name}_code_hash[] = \"${hash}\";\n" PARENT_SCOPE)
  set(listing "${listing}" PARENT_SCOPE)
endfunction()

set(production pipeline/production)
# Motions know nothing of pictures (rooms.txt). What their tasks meet of them are names in records.
hash_artifact(motion ${production}/synthesis/motion_task.cpp ${production}/synthesis/durations_task.cpp
  WITHOUT render scenes)
hash_artifact(film ${production}/film/film_task.cpp ${production}/film/film_equalized.cpp
  ${production}/film/film_dots.cpp ${production}/film/film_tables.cpp)
hash_artifact(sheet ${production}/sheets/sheet_task.cpp ${production}/sheets/stills_task.cpp)
hash_artifact(study ${production}/run/production.cpp)

file(WRITE ${OUTPUT}.new "${header}")
file(COPY_FILE ${OUTPUT}.new ${OUTPUT} ONLY_IF_DIFFERENT)
file(REMOVE ${OUTPUT}.new)
file(WRITE ${OUTPUT}.sources "${listing}")
