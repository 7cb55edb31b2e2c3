# Reads what `gcov --stdout --branch-probabilities` prints.  A message is a statement that calls one of the functions
# below; it was produced when the last call in it ran: what stands before that, as in
# `if (full()) return error_set(...)`, does not count.
BEGIN {
  MESSAGE = "(^|[^a-z_])(error_set|error_prefix|place_error|REFUSE|verdict|log_warning|usage_error)[(]"
  while ((getline line < reasons) > 0)
    if (line !~ /^(#|$)/) { n_reasons++; split(line, part, " \\| "); file_of[n_reasons] = part[1]; text_of[n_reasons] = part[2] }
}

/^ *-: *0:Source:/ { file = $0; sub(/.*Source:/, "", file); ours = index(file, source "core/") == 1; file = substr(file, length(source) + 1); next }
!ours { next }

/^ *[-#=0-9*]+: *[0-9]+:/ {
  count = $0; sub(/:.*/, "", count); gsub(/[ *]/, "", count)
  rest = substr($0, index($0, ":") + 1)
  number = rest + 0
  place = file ":" number
  text[place] = substr(rest, index(rest, ":") + 1)
  if (number > last[file]) last[file] = number
  if (count == "-") next
  count = count ~ /[#=]/ ? 0 : count + 0
  if (!(place in ran) || count > ran[place]) ran[place] = count
  next
}
/^call / { called[place] = /never executed/ ? "no" : "yes"; next }

# Reads from a line to the end of the statement: `words` for a reader and for messages.txt, and was it `produced`?
function read_statement(file, number,   line) {
  words = produced = ""
  do {
    place = file ":" number++
    if (place in called) produced = called[place]
    line = text[place]
    sub(/^ +/, " ", line)
    words = words line
  } while (line !~ /[;}]$/ && number < last[file])
  words = substr(words, 2)
}
function excused(file, words,   i) {
  for (i = 1; i <= n_reasons; i++)
    if (file_of[i] == file && index(words, text_of[i])) { used[i] = 1; return 1 }
  return 0
}

END {
  for (file in last) {
    room = file; sub(/^core\//, "", room); sub(/\/.*/, "", room)
    lines = reached = 0
    for (number = 1; number <= last[file]; number++) {
      place = file ":" number
      if (!(place in ran)) continue
      lines++
      if (ran[place]) reached++
      else print place ":" text[place] > (out "/unreached")
      if (text[place] !~ MESSAGE || text[place] ~ /^(Status|Verdict|void) /) continue
      messages++
      read_statement(file, number)
      if (produced == "yes") continue
      if (excused(file, words)) excuses++
      else { open_messages++; print file ":" number ": " words > (out "/messages") }
    }
    all_lines[room] += lines; all_reached[room] += reached
    total += lines; total_reached += reached
    printf "%6.1f %5d %s\n", 100 * reached / lines, lines - reached, file > (out "/lines")
  }
  close(out "/lines"); close(out "/messages")
  print "room            lines  reached"
  for (room in all_lines) printf "%-12s %8d %7.1f %%\n", room, all_lines[room], 100 * all_reached[room] / all_lines[room] | "sort"
  close("sort")
  share = 100 * total_reached / total
  printf "core         %8d %7.1f %%\n\n", total, share
  printf "%d messages: %d produced by a test, %d with a reason why not, %d neither\n", messages, messages - excuses - open_messages, excuses, open_messages
  if (open_messages) system("sort " out "/messages")
  for (i = 1; i <= n_reasons; i++)
    if (!used[i]) { stale++; print "messages.txt: no such message, or it was produced: " file_of[i] " | " text_of[i] }
  exit share < 90 || open_messages || stale
}
