#include "motion/flat_xml.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/csv_cells.hpp"
#include "base/error.hpp"
#include "base/printable_text.hpp"

namespace fingerpad {
namespace {

// With the depth they bound the paths to 20 MB, whatever the file; a recording has some twenty short ones.
constexpr std::size_t longest_xml_name = 64;
constexpr std::size_t most_xml_texts = 10000;

struct OpenElement {
  std::string name;
  std::size_t text_at;
  long line;
  bool has_children = false;
};

class XmlWalk {
 public:
  XmlWalk(std::string_view xml, const std::string& where) : xml_(xml), where_(where) {}

  std::vector<XmlText> texts() {
    for (std::size_t tag = xml_.find('<'); tag != std::string_view::npos; tag = xml_.find('<', at_)) {
      line_ += std::count(xml_.begin() + static_cast<long>(at_), xml_.begin() + static_cast<long>(tag), '\n');
      take(tag);
    }
    if (!open_.empty()) throw fault(fmt::format("<{}> is not closed", shown(open_.back().name)));
    if (!had_root_) throw fault("holds no element");
    return std::move(found_);
  }

 private:
  Error fault(const std::string& what) const {
    return refused(fmt::format("{}:{}", where_, line_), what + "; as XML it cannot be read");
  }
  static std::string shown(std::string_view name) { return printable(std::string(name), 40); }

  /// Goes on behind what ends with `end`.
  void pass(std::size_t from, std::string_view end) {
    const std::size_t found = xml_.find(end, from);
    if (found == std::string_view::npos) throw fault("ends within a tag");
    line_ +=
        std::count(xml_.begin() + static_cast<long>(from), xml_.begin() + static_cast<long>(found), '\n');
    at_ = found + end.size();
  }

  void take(std::size_t tag) {
    const std::string_view rest = xml_.substr(tag);
    if (rest.starts_with("<!--")) return pass(tag + 4, "-->");
    if (rest.starts_with("<?")) return pass(tag + 2, "?>");
    if (rest.starts_with("<!")) throw fault("has a declaration (<!), which is not read");
    const std::size_t start = tag;
    pass(tag + 1, ">");
    std::string_view inside = xml_.substr(start + 1, at_ - start - 2);
    if (inside.starts_with('/')) return close(trimmed(inside.substr(1)), start);
    const bool is_empty = inside.ends_with('/');
    if (is_empty) inside.remove_suffix(1);
    const std::string_view name = inside.substr(0, inside.find_first_of(" \t\r\n"));
    if (name.empty()) throw fault("has a tag without a name");
    if (name.size() > longest_xml_name)
      throw fault(fmt::format("<{}> has a name of {} characters (at most {})", shown(name), name.size(),
                              longest_xml_name));
    constexpr std::size_t deepest = 32;
    if (open_.size() >= deepest) throw fault("has elements nested too deep");
    if (open_.empty() && had_root_) throw fault("has a second root");
    had_root_ = true;
    if (!open_.empty()) open_.back().has_children = true;
    if (!is_empty) open_.push_back({std::string(name), at_, line_});
  }

  void close(std::string_view name, std::size_t tag) {
    if (open_.empty() || open_.back().name != name)
      throw fault(fmt::format("</{}> closes {}", shown(name),
                              open_.empty() ? "nothing" : "<" + shown(open_.back().name) + ">"));
    const OpenElement element = open_.back();
    if (!element.has_children) {
      if (found_.size() >= most_xml_texts)
        throw fault(fmt::format("has more than {} elements with text", most_xml_texts));
      std::string path;
      for (std::size_t k = 1; k < open_.size(); ++k) path += (k > 1 ? "/" : "") + open_[k].name;
      std::transform(path.begin(), path.end(), path.begin(),
                     [](unsigned char c) { return static_cast<char>(c < 128 ? std::tolower(c) : c); });
      found_.push_back({path, xml_.substr(element.text_at, tag - element.text_at), element.line});
    }
    open_.pop_back();
  }

  std::string_view xml_;
  const std::string& where_;
  std::size_t at_ = 0;
  long line_ = 1;
  bool had_root_ = false;
  std::vector<OpenElement> open_;
  std::vector<XmlText> found_;
};

}  // namespace

std::vector<XmlText> xml_texts(std::string_view xml, const std::string& where) {
  return XmlWalk(xml, where).texts();
}

}  // namespace fingerpad
