# cmake -DINPUT=<file> -DOUTPUT=<header> -DNAME=<constant> -P embed.cmake
# Writes a header that holds a text file as a constant.
file(READ ${INPUT} text)
file(WRITE ${OUTPUT}.new
"// Generated from a file of the source tree.
#pragma once
inline constexpr char ${NAME}[] = R\"embedded(${text})embedded\";
")
file(COPY_FILE ${OUTPUT}.new ${OUTPUT} ONLY_IF_DIFFERENT)
file(REMOVE ${OUTPUT}.new)
