#include "import/formats/mcap/json_message.h"

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace tread {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kDeepestJson = 32;  // objects in objects of a message

// What the parser calls for each thing that it meets.
class JsonNumbers final : public nlohmann::json_sax<Json> {
public:
    explicit JsonNumbers(TopicTable& table) : table_(table) {}

    bool null() override { return passed(); }
    bool boolean(bool value) override { return number(value ? 1 : 0); }
    bool number_integer(number_integer_t value) override { return number(static_cast<double>(value)); }
    bool number_unsigned(number_unsigned_t value) override { return number(static_cast<double>(value)); }
    bool number_float(number_float_t value, const string_t&) override { return number(value); }
    bool string(string_t&) override { return passed(); }
    bool binary(binary_t&) override { return passed(); }
    bool key(string_t& name) override {
        path_.resize(levels_.back().path);
        path_ += (path_.empty() ? "" : ".") + name;
        return true;
    }
    bool start_object(std::size_t) override { return open(false); }
    bool end_object() override { return close(); }
    bool start_array(std::size_t) override { return !levels_.empty() && open(true); }
    bool end_array() override { return close(); }
    bool parse_error(std::size_t, const std::string&, const Json::exception&) override { return false; }

private:
    struct Level {
        std::size_t path;  // length of its path
        bool array;
        bool skipped;
        std::size_t elements = 0;
    };

    // A value that stands alone, in no object, is no message.
    bool number(double value) {
        if (levels_.empty()) return false;
        begin();
        if (!isSkipped()) table_.value(path_, value);
        return true;
    }
    bool passed() {
        begin();
        return !levels_.empty();
    }

    // The next element of an array has its number as name.
    void begin() {
        if (levels_.empty() || !levels_.back().array) return;
        path_.resize(levels_.back().path);
        path_ += "[" + std::to_string(levels_.back().elements++) + "]";
    }
    bool open(bool array) {
        begin();
        const bool skipped = isSkipped() || (array && path_.ends_with("covariance"));
        levels_.push_back({path_.size(), array, skipped});
        return levels_.size() <= kDeepestJson;
    }
    // Beyond the first elements of a long array, and in covariances.
    bool isSkipped() const {
        return !levels_.empty() && (levels_.back().skipped || levels_.back().elements > kMostArrayColumns);
    }
    bool close() {
        path_.resize(levels_.back().path);
        levels_.pop_back();
        return true;
    }

    TopicTable& table_;
    std::string path_;
    std::vector<Level> levels_;
};

std::string textAt(const nlohmann::ordered_json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

}  // namespace

bool readJsonMessage(std::string_view bytes, TopicTable& table) {
    JsonNumbers numbers(table);
    return Json::sax_parse(bytes.begin(), bytes.end(), &numbers);
}

std::vector<JsonProperty> jsonProperties(std::string_view schema) {
    std::vector<JsonProperty> list;
    const auto parsed = nlohmann::ordered_json::parse(schema.begin(), schema.end(), nullptr, false);
    if (!parsed.is_object()) return list;
    const auto properties = parsed.find("properties");
    if (properties == parsed.end() || !properties->is_object()) return list;
    for (const auto& [name, property] : properties->items()) {
        const std::string type = property.is_object() ? textAt(property, "type") : "";
        if (type == "number" || type == "integer" || type == "boolean")
            list.push_back({name, textAt(property, "title"), textAt(property, "description")});
    }
    return list;
}

}  // namespace tread
