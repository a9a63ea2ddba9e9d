# awk -v names="gait FootLock" -f find_tests.awk *_test.cpp, in the folder tests.
# A line for each test that a name means: its file, its name, and a regular expression for ctest. Names
# are those of modules, rooms, files (a source or its test), suites and tests; without any, all tests
# are meant. A name that means none is an error that shows the nearest ones.
function base(path) { sub(/.*\//, "", path); return path }
function folder(path) { sub(/\/?[^\/]*$/, "", path); return path }
function min(a, b) { return a < b ? a : b }

# Letters to insert, delete or replace (Levenshtein).
function edits(a, b,    i, j, row, diagonal, above) {
  for (j = 0; j <= length(b); ++j) row[j] = j
  for (i = 1; i <= length(a); ++i) {
    diagonal = row[0]
    row[0] = i
    for (j = 1; j <= length(b); ++j) {
      above = row[j]
      row[j] = min(min(row[j], row[j - 1]) + 1, diagonal + (substr(a, i, 1) != substr(b, j, 1)))
      diagonal = above
    }
  }
  return row[length(b)]
}

function refuse(name,    known, distance, least, nearest, round, word) {
  for (round = 1; round <= 3; ++round) {
    least = 1e9
    for (known in meant) {
      if (known in shown) continue
      distance = edits(tolower(name), tolower(known))
      if (distance > least || (distance == least && known > word)) continue
      least = distance
      word = known
    }
    shown[word]
    nearest = nearest (round > 1 ? ", " : "") word
  }
  print "mien: there is no test, room or file \"" name "\"; the nearest are " nearest > "/dev/stderr"
  exit 2
}

/^TEST(_F|_P)?\(/ {
  line = $0
  while (line !~ /\)/ && (getline more) > 0) line = line more
  gsub(/^[A-Z_]*\(|\).*|[ \t]/, "", line)
  split(line, part, ",")
  file = FILENAME
  sub(/^\.\//, "", file)
  sub(/_test\.cpp$/, "", file)
  ++count
  suite[count] = part[1]
  test[count] = part[1] "." part[2]
  found[count] = file " " test[count]
  # All that a test may be called by.
  words[count] = " " file " " base(file) " " part[1] " " test[count] " " part[2] " "
  for (place = folder(file); place != ""; place = folder(place)) {
    words[count] = words[count] place " " base(place) " "
  }
  split(words[count], every, " ")
  for (i in every) meant[every[i]]
}

END {
  asked = split(names, name, " ")
  for (i = 1; i <= asked; ++i) {
    gsub(/^(\.\/)?(tests\/)?|\/$|(_test)?\.(cpp|h)$|_test$/, "", name[i])
    if (!(name[i] in meant)) refuse(name[i])
  }
  for (n = 1; n <= count; ++n) {
    whole_suite = asked == 0
    expression = suite[n] "[.]" substr(test[n], length(suite[n]) + 2)
    alone = 0
    for (i = 1; i <= asked; ++i) {
      if (name[i] == test[n] || test[n] == suite[n] "." name[i]) alone = 1
      else if (index(words[n], " " name[i] " ")) whole_suite = 1
    }
    if (whole_suite) print found[n] " " suite[n] "[.]|" suite[n] "$"
    else if (alone) print found[n] " " expression "$|" expression "/"
  }
}
