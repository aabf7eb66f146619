# Writes FILE: the SOURCES (separated by commas) one after the other as one translation unit, for
# cmake -P. Headers are parsed once instead of once for each source. What a source keeps to itself
# in an unnamed namespace lies in a namespace of its own, so that sources cannot meet. Messages and
# debuggers show lines of the sources.
string(REPLACE "," ";" SOURCES "${SOURCES}")
set(unit "// Joined by cmake/JoinSources.cmake.\n")
set(number 0)
foreach(source IN LISTS SOURCES)
  math(EXPR number "${number} + 1")
  file(READ ${source} text)
  string(REGEX REPLACE "(^|\n)namespace {" "\\1namespace joined_${UNIT}_${number} {" text "${text}")
  file(RELATIVE_PATH source ${FOLDER} ${source})  # FOLDER: where the compiler runs
  string(APPEND unit "#line 1 \"${source}\"\n${text}\n")
endforeach()
file(WRITE ${FILE} "${unit}")
