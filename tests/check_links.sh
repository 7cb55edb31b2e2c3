#!/bin/sh
# Fails on a link in a page of the repository to a file that is not there, or to a heading that its page does not have,
# and on a page of docs/ that is named anywhere in the sources and is not there.  Links to the network are not followed.
root=${1:-.}
cd "$root" || exit 2
pages=$(find . -name '*.md' -not -path './build/*' -not -path '*/node_modules/*' -not -path './.git/*')

# The links of a page, one a line, without those in blocks of code.
links() {
  awk '
    /^```/ { code = !code; next }
    !code {
      gsub(/`[^`]*`/, "")
      while (match($0, /\]\([^)]+\)/)) {
        print substr($0, RSTART + 2, RLENGTH - 3)
        $0 = substr($0, RSTART + RLENGTH)
      }
    }' "$1"
}

# The names by which the headings of a page are linked.
anchors() {
  awk '
    /^```/ { code = !code; next }
    !code && /^#+ / {
      sub(/^#+ /, "")
      name = tolower($0)
      gsub(/[^a-z0-9 _-]/, "", name)
      gsub(/ /, "-", name)
      print name
    }' "$1"
}

count=0
for page in $pages; do
  for link in $(links "$page"); do
    case $link in
      http://* | https://* | mailto:*) continue ;;
    esac
    count=$((count + 1))
    file=${link%%#*}
    target=$page
    [ -z "$file" ] || target=$(dirname "$page")/$file
    if [ ! -e "$target" ]; then
      echo "$page: the link $link leads nowhere" && status=1
    elif [ "$file" != "$link" ] && ! anchors "$target" | grep -qxF -- "${link#*#}"; then
      echo "$page: the link $link leads to no heading" && status=1
    fi
  done
done
[ "$count" -ge 30 ] || { echo "only $count links were found: is this the right folder?" && status=1; }

for name in $(grep -rohE '\bdocs/[a-zA-Z0-9/_-]+\.md' $pages core plugins tests configs --include='*.[chsS]*' --include='*.md' --include='*.yaml' --include='*.txt' | sort -u); do
  [ -f "$name" ] || { echo "$name is named, and is not there" && status=1; }
done
exit ${status:-0}
