#include "core/base/json/LimitedJson.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/base/json/JsonFields.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace taa {

using nlohmann::json;

namespace {

/// About what a value takes besides its text: the node of a map with its key, a list with its growth.
constexpr std::size_t kValueBytes = 32, kNestBytes = 96, kKeyBytes = 112;

/// Builds the values as the parser meets them. The library's own parser with a callback takes time that grows
/// with the square of the text, and the one without sees neither depth nor keys that come twice.
class LimitedBuilder {
 public:
  LimitedBuilder(std::string_view text, const JsonLimits& limits) : text_(text), limits_(limits) {}
  json take() { return std::move(root_); }

  bool null() { return add(nullptr); }
  bool boolean(bool value) { return add(value); }
  bool number_integer(std::int64_t value) { return add(value); }
  bool number_unsigned(std::uint64_t value) { return add(value); }
  bool number_float(double value, const std::string&) { return add(value); }
  bool string(std::string& value) {
    spend(value.size());
    return add(std::move(value));
  }
  bool binary(json::binary_t&) { return false; } // JSON has none
  bool start_object(std::size_t) { return open(json::object()); }
  bool start_array(std::size_t) { return open(json::array()); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }

  bool key(std::string& name) {
    spend(kKeyBytes + name.size());
    requireRoom();
    const auto [place, isNew] = open_.back()->emplace(name, nullptr);
    if (!isNew) throw Error(say<"the key \"%1\" comes twice">(shownText(pathOf(openPlace(), name))));
    slot_ = &*place;
    return true;
  }

  bool parse_error(std::size_t position, const std::string&, const json::exception& error) {
    constexpr int kNumberOverflow = 406;
    const std::string_view before = text_.substr(0, std::max<std::size_t>(position, 1) - 1); // the wrong byte
    const std::ptrdiff_t line = std::ranges::count(before, '\n') + 1;
    const std::size_t column = before.size() - before.rfind('\n'); // after npos, which is −1, from 1 as well
    if (error.id == kNumberOverflow)
      throw Error(say<"a number in line %1, column %2 is too large">(line, column));
    if (position > text_.size())
      throw Error(say<"it ends in line %1, column %2, before it is whole">(line, column));
    throw Error(say<"it is not JSON from line %1, column %2 on">(line, column));
  }

 private:
  void spend(std::size_t bytes) {
    spent_ += bytes;
    if (spent_ > limits_.memory)
      throw Error(say<"it would take more than %1 MiB of memory">(limits_.memory >> 20));
  }

  void requireRoom() const {
    if (open_.back()->size() >= limits_.entries)
      throw Error(say<"%1 has more than %2 entries">(shownText(placeName(openPlace())), limits_.entries));
  }

  /// The path of what is read. Looked for when it has to be told, so that files that are right cost nothing.
  std::string openPlace() const {
    std::string place;
    for (std::size_t i = 1; i < open_.size(); ++i) {
      const json& parent = *open_[i - 1];
      if (parent.is_array()) {
        place = elementOf(place, parent.size() - 1);
        continue;
      }
      for (const auto& [key, value] : parent.items())
        if (&value == open_[i]) place = pathOf(place, key);
    }
    return place;
  }

  json* put(json&& value) {
    spend(kValueBytes);
    if (open_.empty()) return &(root_ = std::move(value));
    if (!open_.back()->is_array()) return &(*slot_ = std::move(value));
    requireRoom();
    open_.back()->push_back(std::move(value));
    return &open_.back()->back();
  }
  bool add(json value) {
    put(std::move(value));
    return true;
  }
  bool open(json&& value) {
    spend(kNestBytes);
    if (open_.size() >= static_cast<std::size_t>(limits_.depth))
      throw Error(say<"it is nested deeper than %1 levels">(limits_.depth));
    open_.push_back(put(std::move(value)));
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  std::string_view text_;
  const JsonLimits& limits_;
  json root_;
  std::vector<json*> open_; ///< from the root; only the last of them grows
  json* slot_ = nullptr;    ///< where the value of the last key goes
  std::size_t spent_ = 0;
};

} // namespace

json parseLimited(std::string_view text, const JsonLimits& limits) {
  if (text.size() > limits.bytes)
    throw Error(say<"it has %1 bytes, more than the %2 allowed">(text.size(), limits.bytes));
  if (text.empty()) throw Error(say<"it is empty">());
  LimitedBuilder builder(text, limits);
  json::sax_parse(text.begin(), text.end(), &builder);
  return builder.take();
}

} // namespace taa
