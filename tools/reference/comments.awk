# Turns the headers' own comments into Doxygen's, line by line, so that they need no marks:
#   // before a declaration           -> ///        the file's head -> its page
#   x;  // after one                  -> ///<
#   field(TREAD_FIELD(x), About{"N", "meaning"})  -> beside the member x: its meaning and unit
# Headings (// ---- Tyre ----) stay plain. The inline namespaces of Bullet's two precisions are left out: nobody writes
# them.

{ text[NR] = $0 }

# Fills `found` with the quoted texts after About{; literals in a row are one text.
function literals(line, found,    rest, count, after) {
    rest = line
    sub(/.*About\{/, "", rest)
    gsub(/" +"/, "", rest)
    count = 0
    while (match(rest, /"([^"\\]|\\.)*"/)) {
        found[++count] = substr(rest, RSTART + 1, RLENGTH - 2)
        rest = substr(rest, RSTART + RLENGTH)
    }
    return count
}

# A described field's meaning, put beside the member of that name that was declared last.
function describe(from,    line, more, name, i, count, found, pattern, unit) {
    line = text[from]
    for (i = from + 1; line !~ /\);/ && i <= NR; ++i) {
        more = text[i]
        sub(/^ +/, " ", more)
        line = line more
    }
    name = line
    sub(/.*TREAD_FIELD\(/, "", name)
    sub(/\).*/, "", name)
    count = literals(line, found)
    if (count < 2) return
    unit = found[1] == "" ? "" : found[1] == "-" ? ", no unit" : ", " found[1]
    pattern = "[^A-Za-z0-9_](" name ")( =.*;|;|\\{.*;|,.*;)"
    for (i = from - 1; i > 0; --i) {
        if (text[i] ~ pattern && text[i] ~ /;/ && text[i] !~ /field\(|return|^ *\/\//) {
            if (note[i] == "") note[i] = found[2] unit
            return
        }
    }
}

END {
    for (i = 1; i <= NR; ++i)
        if (text[i] ~ /field\(TREAD_FIELD\(/) describe(i)
    head = 1
    for (i = 1; i <= NR; ++i) {
        line = text[i]
        if (head && line !~ /^\/\//) head = 0
        if (head) {
            sub(/^\/\//, "///", line)
            if (i == 1) line = "/// \\file\n" line
        } else if (line ~ /^ *\/\/ ----/) {
            # a heading
        } else if (line ~ /^ *\/\//) {
            gsub(/\\/, "&&", line)
            sub(/\/\//, "///", line)
        } else if (line ~ /[;,{}] +\/\/ /) {
            sub(/ +\/\/ /, "  ///< ", line)
            if (i in note) line = line "; " note[i]
        } else if (i in note) {
            line = line "  ///< " note[i]
        }
        if (line ~ /^inline namespace bullet_/ || (line == "}" && text[i + 1] ~ /^}  \/\/ namespace tread/)) line = ""
        print line
    }
}
