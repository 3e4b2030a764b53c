// The part of reading a described struct that does not depend on its type: looking up keys, converting values, and
// saying where and why something is wrong. `read_yaml.h` walks the description and calls this.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields/field_path.h"
#include "base/yaml/document.h"
#include "base/yaml/session.h"
#include "tread/curve.h"
#include "tread/describe.h"

namespace tread {

// A value in a file or, when the file does not give it, the place where it would have been.
struct YamlPlace {
    const YamlNode* node = nullptr;  // nullptr: absent
    int line = 0;                    // of the value; of the enclosing map when the value is absent
    int column = 0;
    std::string path;
};

class YamlReader {
public:
    YamlReader(YamlSession& session, const YamlDocument& document) : session_(session), document_(document) {}

    YamlSession& session() const { return session_; }
    std::size_t faults() const { return session_.problems.size(); }
    YamlPlace root(const std::string& path) const;
    void complain(const YamlPlace& place, std::string text) const;

    // The names along the paths of the faults since there were so many, as far as they lie behind `path`.
    std::vector<std::string> faultyNames(std::size_t faults_before, std::string_view path) const;
    // Makes one fault of several that an absent struct gave rise to.
    void gatherMissing(const YamlPlace& place, std::size_t faults_before) const;
    // Complains at `place`, which names the document's file, when most of its keys are none of the names.
    bool rejectsKind(const YamlPlace& place, const YamlDocument& document,
                     std::span<const std::string_view> names) const;

    // Each leaves the value alone when it is absent or wrong; a number without default must not be absent.
    void number(const YamlPlace& place, const About& about, double& value) const;
    void wholeNumber(const YamlPlace& place, const About& about, int& value) const;
    void yesNo(const YamlPlace& place, bool& value) const;
    void text(const YamlPlace& place, std::string& value) const;
    void curve(const YamlPlace& place, const About& about, Curve& value) const;

    // Index of the name that is given; nothing when it is absent or wrong.
    std::optional<std::size_t> choice(const YamlPlace& place, std::span<const std::string_view> names) const;

    // The elements of a list; nothing when the list is absent or something else.
    std::optional<std::vector<YamlPlace>> elements(const YamlPlace& place) const;

    // The keys of a map that are names of the user's own; nothing when the map is absent or something else.
    struct Entry {
        YamlPlace key;
        YamlPlace value;
    };
    std::optional<std::vector<Entry>> entries(const YamlPlace& place) const;

    // `name: value` or the bare `name`, whose value then is absent; nothing when it is absent or wrong.
    struct Alternative {
        std::size_t index;
        YamlPlace place;
    };
    std::optional<Alternative> alternative(const YamlPlace& place, std::span<const std::string_view> names) const;

    // The file that is named in place of a value, as a path; nothing when it does not exist or is already being read.
    std::optional<std::filesystem::path> include(const YamlPlace& place) const;

private:
    friend class YamlFields;
    void expected(const YamlPlace& place, std::string_view what, std::string_view advice) const;
    bool isScalar(const YamlPlace& place, std::string_view what, std::string_view advice) const;
    bool convert(const YamlPlace& place, std::string_view unit, const Limits& limits, double& value) const;
    YamlPlace child(const YamlPlace& parent, std::size_t index, std::string_view name) const;

    YamlSession& session_;
    const YamlDocument& document_;
};

// Whether a complaint is about one of the names, or mentions it.
bool namesAny(std::span<const std::string> names, std::string_view field, std::string_view text);

// Reads and parses a file. When it cannot be read, the fault is at `place`, where the file was named, or concerns the
// file itself when no other file named it.
std::optional<YamlDocument> openYaml(const YamlReader& reader, const YamlPlace& place,
                                     const std::filesystem::path& file);

}  // namespace tread
