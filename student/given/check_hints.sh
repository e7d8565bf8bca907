# Given, for ./check: the hint for the first check that fails, a stage at a time.
# shellcheck shell=sh disable=SC2154 # variables of ./check

# What the check and the answers tell of the mistake, but for its numbers: another try at the same
# mistake goes on with the next stage, and another mistake starts at the first.
mistake_in_short() {
  {
    sed -e '/^    |/d' -e 's/-*[0-9][0-9.]*\(e[-+][0-9]*\)*//g' -e 's/ //g' "$note"
    cat "$work/mistake_$first_part.txt" 2>/dev/null
  } | cksum
}

# Sets `stage`: the one after the last that was opened for this mistake. build/check/hint remembers it.
next_stage() {
  find_mistake
  mistake="${heading%% *} $(mistake_in_short)"
  stage=1
  [ "$(sed 1d "$work/hint" 2>/dev/null)" != "$mistake" ] || stage=$(($(sed 1q "$work/hint") + 1))
  printf '%s\n' "$stage" "$mistake" >"$work/hint"
}

hint() {
  if [ -z "$first_part" ]; then
    echo "Every public check passes: no hint is needed."
    return
  fi
  if [ -z "$first_check" ]; then
    print_first
    return
  fi
  heading=$(heading_of "$first_check")
  note=$work/notes/part$first_part/$first_check
  page=hints/$(stem_of "$first_part").md
  next_stage
  echo "For: $first_title"
  print_stage $((stage < 3 ? stage : 3))
  if [ "$stage" = 3 ]; then
    echo "That was the last stage. All are in $page."
  elif [ "$stage" -gt 3 ]; then
    echo "That was the last stage again; there is no further one. Work its numbers out by"
    echo "hand, print the same ones in your program, and see where they part. All stages"
    echo "are in $page."
  fi
}

print_stage() {
  awk -v heading="## $heading" -v stage="$1" '
    NR == 3 && stage == 3 { state = $0; sub(/^.*Unless said otherwise, t/, "T", state) }
    /^## / { here = ($0 == heading); n = 0 }
    here && /^### / { n++; if (n == stage) print "Hint " substr(heading, 4) ", stage " n " of 3: " substr($0, 5); if (n == stage && n == 3) print "\n" state; next }
    /^```/ { fenced = !fenced; next }
    here && n == stage { print (fenced ? "    " : "") $0 }
  ' "$page" | fold -s -w 78
}
