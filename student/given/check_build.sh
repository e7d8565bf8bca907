# Given, for ./check: how it builds, and what it says of what is missing, wrong or doubtful.
# shellcheck shell=sh disable=SC2034,SC2154,SC3045 # variables of ./check, by number through eval

# ---- what has to be there ----

# how_to_install APT BREW
how_to_install() {
  case $(uname -s) in
    Darwin) echo "brew install $2" ;;
    *) if command -v apt-get >/dev/null; then echo "sudo apt install $1"; else
      echo "your package manager; Debian calls it $1"
    fi ;;
  esac
}

# The folder may have been moved; what CMake built elsewhere is of no use then.
forget_another_folder() {
  if [ -e "$work/folder" ] && [ "$(cat "$work/folder")" != "$PWD" ]; then rm -rf build; fi
  mkdir -p "$work" 2>/dev/null
  if [ ! -w build ] || [ ! -w "$work" ]; then
    fail "the folder build/ can't be written here: move the handout to your own files"
  fi
  echo "$PWD" >"$work/folder"
}

configure() {
  command -v cmake >/dev/null || fail "CMake is missing; install it with: $(how_to_install cmake cmake)"
  generator='Unix Makefiles'
  ! command -v ninja >/dev/null || generator=Ninja
  cmake -S . -B build -G "$generator" >"$work/configure.txt" 2>&1 || why_not_configured
}

why_not_configured() {
  log=$work/configure.txt
  case $(uname -s) in Darwin) system=macOS ;; *) system='Debian, Ubuntu' ;; esac
  missing=$(sed -n 's/^ *Missing: *//p' "$log")
  rm -f build/CMakeCache.txt
  if [ -n "$missing" ]; then
    fail "missing: $missing; install with: $(sed -n "s/^ *$system: *//p" "$log")"
  elif grep -q 'CMAKE_MAKE_PROGRAM' "$log"; then
    fail "the program make is missing; install it with: $(how_to_install make make)"
  elif grep -q -e 'CMAKE_CXX_COMPILER' -e 'compiler is not able' "$log"; then
    [ "$(uname -s)" != Darwin ] || fail "a C++ compiler is missing; install it with: xcode-select --install"
    fail "a C++ compiler is missing; install it with: $(how_to_install g++ gcc)"
  fi
  tail -n 15 "$log" >&2
  fail "CMake could not prepare the build; all of what it says is in $log"
}

# ---- building ----

build_targets() {
  cmake --build build --parallel "$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)" \
    --target "$@" >"$work/build.txt" 2>&1
  code=$?
  remember_warnings
  return $code
}

# A build says the warnings of what it compiles; those of other files still stand.
remember_warnings() {
  touch "$work/warnings"
  awk -v here="$PWD/" '
    FILENAME == ARGV[1] {
      at = index($0, here); if (at) $0 = substr($0, 1, at - 1) substr($0, at + length(here))
      if (match($0, /\.dir\/src\/.*\.o$/)) compiled[substr($0, RSTART + 5, RLENGTH - 7)]
      if (/^src\/[^:]*:[0-9]+:([0-9]+:)? warning: /) said[$0]
      next
    }
    { file = $0; sub(/:.*/, "", file); if (!(file in compiled)) said[$0] }
    END { for (line in said) print line }
  ' "$work/build.txt" "$work/warnings" | sort -t : -k 1,1 -k 2,2n >"$work/warnings.new"
  mv "$work/warnings.new" "$work/warnings"
}

forget_warnings() { # of a file that is another now, or gone
  [ -e "$work/warnings" ] || return
  grep -v "^$1:" "$work/warnings" >"$work/warnings.new"
  mv "$work/warnings.new" "$work/warnings"
}

# A build looks at times alone, and a file may come back with an old one, as from a zip.
touch_what_changed() {
  sources >"$work/sources.new"
  if [ -e "$work/sources" ]; then
    grep -v -x -F -f "$work/sources" "$work/sources.new" | while read -r _ _ file; do touch "$file"; done
    grep -v -x -F -f "$work/sources.new" "$work/sources" |
      while read -r _ _ file; do forget_warnings "$file"; done
  fi
  mv "$work/sources.new" "$work/sources"
}

# Sets built_N to yes, no (its own file doesn't compile) or the number of a part that it needs.
build_parts() {
  built_1=yes built_2=yes built_3=yes built_4=yes
  targets=''
  touch_what_changed
  for n in $parts; do targets="$targets $(stem_of "$n")_test"; done
  # shellcheck disable=SC2086
  build_targets $targets && return
  if grep -q '^CMake Error' "$work/build.txt"; then
    cp "$work/build.txt" "$work/configure.txt"
    why_not_configured
  fi
  for n in 1 2 3 4; do
    for part in $parts; do
      case " $part $(earlier_parts "$part") " in *" $n "*) build_part "$n"; break ;; esac
    done
  done
}

earlier_parts() { # that a part calls
  case $1 in 3) echo 1 2 ;; 4) echo 1 2 3 ;; esac
}

build_part() {
  for earlier in $(earlier_parts "$1"); do
    eval "[ \"\$built_$earlier\" = yes ]" || { eval "built_$1=$earlier"; return; }
  done
  build_targets "$(stem_of "$1")_test" && return
  eval "built_$1=no"
  first_error "$work/build.txt" | cut -c 1-200 >"$work/error_$1.txt"
}

# The first error with the file and line that it comes from: an error inside of Eigen is told with
# the student's own line that asked for it.
first_error() {
  awk -v here="$PWD/" '
    { line = $0; at = index(line, here); if (at) line = substr(line, 1, at - 1) substr(line, at + length(here)) }
    !own && line ~ /(^|[ \t])(src|include)\/[^ :]*:[0-9]+/ && (said || line ~ /required from|instantiation of/) {
      own = line; sub(/^.*[ \t]/, "", own); match(line, /(src|include)\/[^ :]*:[0-9]+/)
      own = substr(line, RSTART, RLENGTH)
    }
    !said && line ~ /: (fatal )?error: / && line !~ /^(collect2|clang[^ ]*|ld[^ ]*): / { said = line; more = 2; inside = line !~ /^(src|include)\//; next }
    more > 0 { more--; rest = rest "\n  " line }
    !missing && /undefined reference to|Undefined symbols|undefined symbol|multiple definition of|duplicate symbol/ {
      missing = line; sub(/^.*(\(.*\): |ld: )/, "", missing)
    }
    END {
      if (said && !inside) { sub(/:[0-9]+: (fatal )?error: /, ": ", said); print "  " said rest }
      else if (said) {
        sub(/^.*error: /, "", said); sub(/^static assertion failed:? */, "", said)
        if (match(said, /[A-Z]+_[A-Z]+_[A-Z_0-9]+/)) { said = tolower(substr(said, RSTART, RLENGTH)); gsub(/_/, " ", said) }
        print "  " (own ? own : "a header") ": " said
      } else if (missing) print "  " missing
      else print "  the build failed; what it says is in '"$work"'/build.txt"
    }' "$1"
}
