// A list for each type that a variant can hold.
#pragma once

#include <tuple>
#include <variant>
#include <vector>

namespace taa {

template <class Variant>
class ListsOf;

template <class... Types>
class ListsOf<std::variant<Types...>> {
 public:
  template <class T>
  std::vector<T>& all() {
    return std::get<std::vector<T>>(lists_);
  }
  template <class T>
  const std::vector<T>& all() const {
    return std::get<std::vector<T>>(lists_);
  }
  /// Calls `act` with each list, in the order of the variant's types.
  template <class Act>
  void forEachList(Act act) {
    (act(all<Types>()), ...);
  }

 private:
  std::tuple<std::vector<Types>...> lists_;
};

} // namespace taa
