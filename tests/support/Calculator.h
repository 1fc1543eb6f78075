// Works out the arithmetic that core/explanation/RowExplanation.h describes.
#pragma once

#include "core/base/Half.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

namespace taa::test {

/// A number or a tuple; arithmetic is channel by channel, a number goes with each.
using Values = std::vector<double>;

/// Reads the arithmetic that RowExplanation.h describes.
class Calculator {
 public:
  /// `bias`: relative; what is rounded is moved by that before.
  explicit Calculator(const std::string& text, double bias = 0.0) : text_(text), bias_(bias) {
    replace("−", "-");
    replace("×", "*");
    replace("√", "sqrt");
    replace("log₂", "logtwo");
  }
  Values result() {
    const Values value = sum();
    skip();
    EXPECT_EQ(place_, text_.size()) << "left over in " << text_;
    return value;
  }

 private:
  void replace(const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text_.find(from, at)) != std::string::npos; at += to.size())
      text_.replace(at, from.size(), to);
  }
  void skip() {
    while (place_ < text_.size() && text_[place_] == ' ') ++place_;
  }
  bool take(char character) {
    skip();
    if (place_ >= text_.size() || text_[place_] != character) return false;
    ++place_;
    return true;
  }
  template <typename Operation>
  static Values apply(const Values& a, const Values& b, Operation operation) {
    const std::size_t count = std::max(a.size(), b.size());
    Values result(count);
    for (std::size_t i = 0; i < count; ++i)
      result[i] = operation(a[a.size() == 1 ? 0 : i], b[b.size() == 1 ? 0 : i]);
    return result;
  }
  Values sum() {
    Values value = product();
    for (;;) {
      if (take('+'))
        value = apply(value, product(), std::plus<>());
      else if (take('-'))
        value = apply(value, product(), std::minus<>());
      else
        return value;
    }
  }
  Values product() {
    Values value = power();
    for (;;) {
      if (take('*'))
        value = apply(value, power(), std::multiplies<>());
      else if (take('/'))
        value = apply(value, power(), std::divides<>());
      else
        return value;
    }
  }
  Values power() {
    if (take('-')) return apply({0.0}, power(), std::minus<>());
    const Values base = atom();
    if (!take('^')) return base;
    return apply(base, atom(), [](double a, double b) { return std::pow(a, b); });
  }
  std::vector<Values> arguments() {
    std::vector<Values> list{sum()};
    while (take(',')) list.push_back(sum());
    EXPECT_TRUE(take(')')) << text_.substr(place_);
    return list;
  }
  Values atom() {
    if (take('|')) {
      const Values inside = sum();
      EXPECT_TRUE(take('|'));
      return apply(inside, {0.0}, [](double a, double) { return std::fabs(a); });
    }
    if (take('(')) {
      Values tuple;
      for (const Values& part : arguments()) tuple.insert(tuple.end(), part.begin(), part.end());
      return tuple;
    }
    skip();
    if (place_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[place_])) != 0)
      return called();
    char* end = nullptr;
    const double number = std::strtod(text_.c_str() + place_, &end);
    const std::size_t length = static_cast<std::size_t>(end - text_.c_str()) - place_;
    EXPECT_GT(length, 0u) << "no number at " << text_.substr(place_);
    if (length == 0) place_ = text_.size();
    place_ += length;
    return {number};
  }
  Values called() {
    std::string name;
    while (std::isalpha(static_cast<unsigned char>(text_[place_])) != 0) name += text_[place_++];
    EXPECT_TRUE(take('(')) << name;
    std::vector<Values> list = arguments();
    const auto fold = [&](auto operation) {
      Values value = list.front();
      for (std::size_t i = 1; i < list.size(); ++i) value = apply(value, list[i], operation);
      return value;
    };
    const auto each = [&](auto function) {
      return apply(list.front(), {0.0}, [&](double a, double) { return function(a); });
    };
    if (name == "max") return fold([](double a, double b) { return std::max(a, b); });
    if (name == "min") return fold([](double a, double b) { return std::min(a, b); });
    if (name == "clamp") {
      const Values low = apply(list[0], list[1], [](double a, double b) { return std::max(a, b); });
      return apply(low, list[2], [](double a, double b) { return std::min(a, b); });
    }
    if (name == "sqrt") return each([](double a) { return std::sqrt(a); });
    if (name == "floor") return each([&](double a) { return std::floor(a * (1.0 + bias_)); });
    if (name == "half")
      return each([&](double a) {
        return static_cast<double>(roundedToHalf(static_cast<float>(a * (1.0 + bias_))));
      });
    if (name == "logtwo") return each([](double a) { return std::log2(a); });
    if (name == "cos") return each([](double a) { return std::cos(a); });
    if (name == "exp") return each([](double a) { return std::exp(a); });
    if (name == "smooth")
      return each([](double a) {
        const double x = std::clamp(a, 0.0, 1.0);
        return x * x * (3 - 2 * x);
      });
    ADD_FAILURE() << "unknown function " << name;
    return {0.0};
  }

  std::string text_;
  double bias_;
  std::size_t place_ = 0;
};

} // namespace taa::test
