#include "base/yaml/document.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <sstream>
#include <unordered_map>

#include "base/text/concat.h"
#include "base/text/text_file.h"

namespace tread {
namespace {

// No described struct nests this deep; the parser's and our own recursion end here.
constexpr std::size_t kDeepest = 64;
// Values of a document with every alias written out.
constexpr std::size_t kMostValues = 1'000'000;

struct Fault {
    TextPosition position;
    std::string text;
};

// yaml-cpp 0.7 decodes the escapes \N and \_ (U+0085 and U+00A0) to the last byte of their UTF-8 alone.
std::string withWholeEscapes(std::string_view scalar) {
    std::string whole;
    while (true) {
        const std::size_t stray = findInvalidUtf8(scalar);
        whole += scalar.substr(0, stray);
        if (stray == std::string_view::npos) return whole;
        whole += '\xC2';
        whole += scalar[stray];
        scalar.remove_prefix(stray + 1);
    }
}

// Positions as an editor shows them: the parser counts bytes, people count characters.
class Positions {
public:
    explicit Positions(std::string_view text) : text_(text) {
        for (std::size_t i = 0; i < text.size(); ++i) {
            if (text[i] == '\n') line_starts_.push_back(i + 1);
        }
    }

    TextPosition operator()(const YAML::Mark& mark) const {
        if (mark.line < 0) return {0, 0};
        const auto line = static_cast<std::size_t>(mark.line);
        int column = mark.column + 1;
        // In a line longer than people write, bytes will do.
        if (line < line_starts_.size() && mark.column < kLongestLine) {
            const std::string_view before = text_.substr(line_starts_[line], static_cast<std::size_t>(mark.column));
            column = positionOf(before, before.size()).column;
        }
        return {mark.line + 1, column};
    }

private:
    static constexpr int kLongestLine = 1000;
    std::string_view text_;
    std::vector<std::size_t> line_starts_{0};
};

// Builds the tree from the parser's events. Aliases are shared, never expanded, but counted as if they were.
class TreeBuilder final : public YAML::EventHandler {
public:
    TreeBuilder(std::string_view text, std::vector<YamlNode>& nodes) : positions_(text), nodes_(nodes) {}

    void OnDocumentStart(const YAML::Mark& mark) override {
        if (++documents_ > 1)
            fail(mark,
                 "found a second document, expected one in a file; remove the rest, or correct the indentation here");
    }
    void OnDocumentEnd() override {}

    void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
        addToParent(mark, open(mark, anchor, YamlNode::Kind::nothing));
    }

    void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
        const auto target = anchors_.find(anchor);
        const bool is_open =
            target == anchors_.end() || std::find(open_.begin(), open_.end(), target->second) != open_.end();
        if (is_open) fail(mark, "found an alias inside the value that it stands for; write the value out");
        addToParent(mark, target->second);
    }

    void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  const std::string& value) override {
        rejectTag(mark, tag);
        const std::size_t index = open(mark, anchor, YamlNode::Kind::scalar);
        nodes_[index].text = withWholeEscapes(value);
        nodes_[index].quoted = tag == "!";
        addToParent(mark, index);
    }

    void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                         YAML::EmitterStyle::value) override {
        rejectTag(mark, tag);
        open_.push_back(open(mark, anchor, YamlNode::Kind::list));
        marks_.push_back(mark);
    }
    void OnSequenceEnd() override { closeInnermost(); }

    void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                    YAML::EmitterStyle::value) override {
        rejectTag(mark, tag);
        open_.push_back(open(mark, anchor, YamlNode::Kind::map));
        marks_.push_back(mark);
    }
    void OnMapEnd() override { closeInnermost(); }

    TextPosition position(const YAML::Mark& mark) const { return positions_(mark); }

private:
    // Size and height with every alias written out.
    struct Extent {
        std::size_t values = 1;
        std::size_t height = 1;
    };

    [[noreturn]] void fail(const YAML::Mark& mark, std::string text) const {
        throw Fault{positions_(mark), std::move(text)};
    }

    void rejectTag(const YAML::Mark& mark, const std::string& tag) const {
        const bool plain = tag.empty() || tag == "?" || tag == "!";
        if (!plain) fail(mark, "found a YAML tag, expected a plain value; remove the word that begins with \"!\"");
    }

    std::size_t open(const YAML::Mark& mark, YAML::anchor_t anchor, YamlNode::Kind kind) {
        if (open_.size() >= kDeepest) fail(mark, "found values nested more than 64 deep; check the brackets");
        const std::size_t index = nodes_.size();
        const TextPosition position = positions_(mark);
        nodes_.push_back({kind, {}, false, position.line, position.column, {}});
        extents_.push_back({});
        if (anchor != 0) anchors_[anchor] = index;
        return index;
    }

    void closeInnermost() {
        const std::size_t index = open_.back();
        const YAML::Mark mark = marks_.back();
        open_.pop_back();
        marks_.pop_back();
        addToParent(mark, index);
    }

    void addToParent(const YAML::Mark& mark, std::size_t child) {
        if (open_.empty()) return;
        const std::size_t parent = open_.back();
        nodes_[parent].children.push_back(child);
        Extent& extent = extents_[parent];
        extent.values += extents_[child].values;
        extent.height = std::max(extent.height, extents_[child].height + 1);
        if (extent.values > kMostValues) fail(mark, "found more than a million values; write fewer, or fewer aliases");
        if (extent.height > kDeepest) fail(mark, "found aliases nested more than 64 deep; write them out");
    }

    Positions positions_;
    std::vector<YamlNode>& nodes_;
    std::vector<Extent> extents_;
    std::vector<std::size_t> open_;  // lists and maps that have begun and not ended, outermost first
    std::vector<YAML::Mark> marks_;  // and where they began
    std::unordered_map<YAML::anchor_t, std::size_t> anchors_;
    int documents_ = 0;
};

}  // namespace

std::optional<YamlDocument> parseYaml(std::string_view text, const std::string& file, std::vector<Problem>& problems) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
    if (!isPlainText(text, file, problems)) return {};

    YamlDocument document{file, {}};
    TreeBuilder builder(text, document.nodes);
    const auto refuse = [&](TextPosition position, std::string fault) {
        problems.push_back({file, position.line, position.column, "", std::move(fault)});
        return std::nullopt;
    };
    try {
        // yaml-cpp 0.7 takes a quoted text that never ends for one that ends with the file, unless the document does.
        std::istringstream stream{concat({text, text.ends_with('\n') ? "" : "\n", "...\n"})};
        YAML::Parser parser(stream);
        while (parser.HandleNextDocument(builder)) {
        }
    } catch (const Fault& fault) {
        return refuse(fault.position, fault.text);
    } catch (const YAML::Exception& error) {
        const bool is_quote = error.msg == YAML::ErrorMsg::DOC_IN_SCALAR || error.msg == YAML::ErrorMsg::EOF_IN_SCALAR;
        if (is_quote && !document.nodes.empty()) {
            const YamlNode& last = document.nodes.back();
            return refuse({last.line, last.column},
                          "found no end of the quoted text that begins after this place; close the quotation mark");
        }
        return refuse(builder.position(error.mark), concat({"found text that is not YAML (", error.msg,
                                                            "); check indentation, colons, quotes and brackets here"}));
    }
    if (document.nodes.empty() || document.root().kind == YamlNode::Kind::nothing) {
        return refuse({0, 0}, "found nothing in the file, expected \"key: value\" lines; check the path");
    }
    return document;
}

}  // namespace tread
