#include "symbol/document.hpp"

#include "symbol/suggest.hpp"

#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>

#define TOML_EXCEPTIONS 1
#include <toml++/toml.h>

namespace kov {

const Entry* Entry::find(std::string_view key) const {
  for (const auto& [name, entry] : members_)
    if (name == key) return &entry;
  return nullptr;
}

const Entry& Entry::at(std::string_view key) const {
  if (!is_table()) throw error("'" + name_ + "' must be a table");
  if (const Entry* e = find(key)) return *e;
  throw error("the key '" + std::string(key) + "' is missing" +
              (name_.empty() ? std::string() : " in [" + name_ + "]"));
}

void Entry::check_keys(std::initializer_list<std::string_view> known) const {
  if (!is_table()) throw error("'" + name_ + "' must be a table");
  const std::vector<std::string> names(known.begin(), known.end());
  for (const auto& [key, entry] : members_) {
    if (std::find(names.begin(), names.end(), key) != names.end()) continue;
    const auto guess = nearest(key, names);
    throw entry.key_error(
        "unknown key '" + key + "'" + (name_.empty() ? std::string() : " in [" + name_ + "]"),
        guess ? "did you mean '" + *guess + "'?" : "known keys: " + enumerate(names));
  }
}

const std::string& Entry::string() const {
  if (kind_ != Kind::string)
    throw error("'" + name_ + "' must be a string", "write the value between quotation marks");
  return text_;
}
long Entry::integer() const {
  if (kind_ != Kind::integer) throw error("'" + name_ + "' must be an integer");
  return number_;
}
bool Entry::boolean() const {
  if (kind_ != Kind::boolean) throw error("'" + name_ + "' must be true or false");
  return flag_;
}
const std::vector<Entry>& Entry::array() const {
  if (kind_ != Kind::array) throw error("'" + name_ + "' must be an array");
  return items_;
}
std::vector<const Entry*> Entry::list() const {
  if (kind_ != Kind::array) return {this};
  std::vector<const Entry*> all;
  for (const auto& item : items_)
    all.push_back(&item);
  return all;
}
std::vector<std::string> Entry::strings() const {
  std::vector<std::string> all;
  for (const Entry* item : list())
    all.push_back(item->string());
  return all;
}

Expression Entry::expression(bool allow_equation) const {
  if (kind_ == Kind::integer)
    return parse_expression(std::to_string(number_), source_->file, allow_equation);
  const std::string& text = string();
  Origin origin{source_->file, source_->text, 0, 1, name_};
  if (line_ > 0 && static_cast<std::size_t>(line_) <= source_->lines.size()) {
    const std::size_t start =
        source_->lines[static_cast<std::size_t>(line_ - 1)] + static_cast<std::size_t>(column_) - 1;
    for (const std::size_t quotes : {1U, 3U, 4U})
      if (source_->text.compare(std::min(start + quotes, source_->text.size()), text.size(),
                                text) == 0) {
        origin.offset = start + quotes;
        return parse_expression(text, std::make_shared<const Origin>(std::move(origin)),
                                allow_equation);
      }
  }
  // The string has escapes: count inside it, from its line.
  origin.text = text;
  origin.first_line = line_;
  return parse_expression(text, std::make_shared<const Origin>(std::move(origin)), allow_equation);
}

InputError Entry::error_at(long line, long column, std::size_t length, std::string message,
                           std::string hint) const {
  std::string text;
  if (line > 0 && static_cast<std::size_t>(line) <= source_->lines.size()) {
    const std::size_t start = source_->lines[static_cast<std::size_t>(line - 1)];
    text = source_->text.substr(start, source_->text.find('\n', start) - start);
  }
  return {source_->file,   line,           column, static_cast<long>(length), std::move(message),
          std::move(hint), std::move(text)};
}

InputError Entry::error(std::string message, std::string hint) const {
  const std::size_t length = kind_ == Kind::string ? text_.size() + 2 : 1;
  return error_at(line_, column_, length, std::move(message), std::move(hint));
}

InputError Entry::key_error(std::string message, std::string hint) const {
  if (key_line_ == 0) return error(std::move(message), std::move(hint));
  return error_at(key_line_, key_column_, name_.size(), std::move(message), std::move(hint));
}

/// Copies toml++'s tree; the only place that knows toml++.
class DocumentReader {
public:
  static Entry parse(std::string text, const std::string& name) {
    auto source = std::make_shared<Entry::Source>();
    source->file = name;
    source->text = std::move(text);
    source->lines.push_back(0);
    for (std::size_t i = 0; i < source->text.size(); ++i)
      if (source->text[i] == '\n') source->lines.push_back(i + 1);
    try {
      const toml::table table =
          toml::parse(std::string_view(source->text), std::string_view(source->file));
      return copy(table, "", source, 0);
    } catch (const toml::parse_error& e) {
      Entry place;
      place.source_ = source;
      place.line_ = static_cast<long>(e.source().begin.line);
      place.column_ = static_cast<long>(e.source().begin.column);
      throw place.error("not TOML: " + std::string(e.description()));
    }
  }

private:
  static Entry copy(const toml::node& node, const std::string& name,
                    const std::shared_ptr<const Entry::Source>& source, int depth) {
    Entry e;
    e.source_ = source;
    e.name_ = name;
    e.line_ = static_cast<long>(node.source().begin.line);
    e.column_ = static_cast<long>(node.source().begin.column);
    if (depth > 32) throw e.error("tables are nested too deeply");
    if (const auto* s = node.as_string()) {
      e.kind_ = Entry::Kind::string;
      e.text_ = s->get();
    } else if (const auto* i = node.as_integer()) {
      e.kind_ = Entry::Kind::integer;
      e.number_ = i->get();
    } else if (const auto* b = node.as_boolean()) {
      e.kind_ = Entry::Kind::boolean;
      e.flag_ = b->get();
    } else if (const auto* a = node.as_array()) {
      e.kind_ = Entry::Kind::array;
      for (const auto& item : *a)
        e.items_.push_back(copy(item, name, source, depth + 1));
    } else if (const auto* t = node.as_table()) {
      e.kind_ = Entry::Kind::table;
      for (const auto& [key, value] : *t) {
        Entry member = copy(value, std::string(key.str()), source, depth + 1);
        member.key_line_ = static_cast<long>(key.source().begin.line);
        member.key_column_ = static_cast<long>(key.source().begin.column);
        e.members_.emplace_back(std::string(key.str()), std::move(member));
      }
      std::stable_sort(e.members_.begin(), e.members_.end(), [](const auto& x, const auto& y) {
        return std::pair(x.second.line_, x.second.column_) <
               std::pair(y.second.line_, y.second.column_);
      });
    }
    return e;
  }
};

Entry parse_document(std::string text, const std::string& name) {
  return DocumentReader::parse(std::move(text), name);
}

Entry read_document(const std::string& path) {
  constexpr std::size_t limit = std::size_t{16} << 20;
  std::string text;
  if (path == "-") {
    text.assign(std::istreambuf_iterator<char>(std::cin), {});
  } else {
    std::ifstream in(path, std::ios::binary);
    if (!in) throw InputError(path, 0, 0, 1, "the file cannot be opened");
    text.assign(std::istreambuf_iterator<char>(in), {});
    if (in.bad()) throw InputError(path, 0, 0, 1, "the file cannot be read");
  }
  if (text.size() > limit) throw InputError(path, 0, 0, 1, "the file is larger than 16 MB");
  return parse_document(std::move(text), path);
}

} // namespace kov
