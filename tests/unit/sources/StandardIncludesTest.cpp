// Reads the sources: every file includes the standard headers whose names it says. Which header brings
// another along differs from one standard library to the next, so that a file without its own includes
// compiles on the developers' system only.
#include "core/base/Files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fs = std::filesystem;

namespace {

/// Headers and what the project takes from them. Any header that lists a name will do for it; the first is
/// named.
constexpr std::pair<std::string_view, std::string_view> kHeaders[] = {
    {"cstddef", "byte max_align_t ptrdiff_t size_t"},
    {"algorithm",
     "adjacent_find all_of any_of clamp copy copy_n count equal fill fill_n find find_if lower_bound max "
     "max_element min min_element none_of nth_element reverse rotate sort stable_sort transform unique "
     "upper_bound ranges::adjacent_find ranges::all_of ranges::any_of ranges::binary_search ranges::copy "
     "ranges::copy_if ranges::count ranges::count_if ranges::equal ranges::fill ranges::find ranges::find_if "
     "ranges::find_if_not ranges::for_each ranges::is_partitioned ranges::is_sorted ranges::lower_bound "
     "ranges::move "
     "ranges::max "
     "ranges::max_element ranges::min ranges::min_element ranges::none_of ranges::nth_element "
     "remove_if stable_partition ranges::remove_copy_if ranges::reverse ranges::sort "
     "ranges::stable_partition ranges::stable_sort "
     "ranges::mismatch ranges::set_symmetric_difference ranges::transform ranges::unique ranges::upper_bound "
     "ranges::contains "
     "ranges::replace "
     "size_t ptrdiff_t initializer_list ranges::remove ranges::minmax_element minmax_element minmax "
     "swap_ranges ranges::includes ranges::set_intersection"},
    {"array", "array get to_array tuple_size_v size_t ptrdiff_t begin end size initializer_list"},
    {"atomic", "atomic"},
    {"bitset", "bitset"},
    {"bit", "bit_cast bit_ceil bit_width endian has_single_bit countr_zero popcount"},
    {"cctype", "isalnum isalpha isdigit islower isspace isupper isxdigit tolower toupper isprint iscntrl"},
    {"charconv", "chars_format from_chars to_chars"},
    {"chrono", "chrono chrono_literals milli"},
    {"cmath", "abs acos asin atan atan2 cbrt ceil copysign cos cosh exp exp2 expm1 fabs floor fmax fmin fmod "
              "frexp hypot ilogb "
              "isfinite isinf isnan ldexp log log10 log1p log2 lround modf nan nanf nextafter pow remainder "
              "nearbyint round signbit "
              "sin sqrt tan trunc erf"},
    {"complex", "arg complex conj norm polar"},
    {"concepts", "integral same_as invocable floating_point convertible_to"},
    {"condition_variable", "condition_variable"},
    {"csignal", "raise sig_atomic_t signal"},
    {"cstdint", "int16_t int32_t int64_t int8_t uint16_t uint32_t uint64_t uint8_t uintmax_t uintptr_t"},
    {"cstdio",
     "fclose fopen fprintf fputs fread fwrite printf remove rename setvbuf size_t snprintf sscanf FILE "
     "fflush perror puts"},
    {"cstdlib", "abs atoi exit getenv size_t strtod strtof strtol abort quick_exit"},
    {"cstring", "memchr memcmp memcpy memset ptrdiff_t size_t strchr strcmp strerror strlen strstr"},
    {"ctime", "clock clock_t time time_t tm localtime gmtime strftime"},
    {"deque", "deque erase erase_if ptrdiff_t size_t initializer_list"},
    {"exception", "current_exception exception exception_ptr make_exception_ptr rethrow_exception terminate"},
    {"filesystem", "error_code filesystem"},
    {"fstream", "fixed fstream ifstream ios ofstream ostream streamsize"},
    {"functional",
     "cref divides function greater hash less less_equal minus multiplies plus ptrdiff_t ranges::greater "
     "ranges::greater_equal ranges::less ref size_t invoke bind_front identity"},
    {"future", "async future future_status launch promise"},
    {"initializer_list", "initializer_list"},
    {"iomanip", "fixed ios put_time setfill setprecision setw streamsize hex"},
    {"ios", "fixed ios streamsize hex"},
    {"iosfwd", "ostream istream"},
    {"iostream", "cerr cin cout endl fixed flush ios ostream istream streamsize"},
    {"iterator", "advance back_inserter begin distance end make_move_iterator next prev size ssize inserter "
                 "istreambuf_iterator"},
    {"limits", "numeric_limits"},
    {"list", "erase erase_if list ptrdiff_t size_t"},
    {"map", "begin end erase erase_if initializer_list map multimap pair ptrdiff_t size size_t"},
    {"memory", "addressof enable_shared_from_this make_shared make_unique ptrdiff_t shared_ptr size_t "
               "unique_ptr weak_ptr "
               "static_pointer_cast dynamic_pointer_cast"},
    {"mutex", "call_once lock_guard mutex once_flag scoped_lock unique_lock"},
    {"new", "bad_alloc nothrow"},
    {"numbers", "numbers"},
    {"numeric", "accumulate gcd iota lcm lerp midpoint reduce inner_product partial_sum"},
    {"optional", "make_optional nullopt nullopt_t optional ptrdiff_t size_t"},
    {"ostream", "endl fixed flush ios ostream streamsize"},
    {"random", "random_device minstd_rand mt19937 normal_distribution uniform_int_distribution "
               "uniform_real_distribution mt19937_64"},
    {"ranges", "ranges::subrange views ranges::iota_view"},
    {"ratio", "milli"},
    {"regex", "regex regex_match regex_replace regex_search smatch sregex_iterator sregex_token_iterator "
              "cregex_iterator regex_constants regex_error"},
    {"set", "begin end erase erase_if multiset ptrdiff_t set size size_t initializer_list"},
    {"span", "as_bytes begin end ptrdiff_t size size_t span initializer_list as_writable_bytes"},
    {"sstream", "fixed ios istringstream ostream ostringstream streamsize stringstream"},
    {"stdexcept", "invalid_argument logic_error out_of_range runtime_error"},
    {"string", "begin end erase erase_if getline initializer_list ptrdiff_t size size_t stod stof stoi stol "
               "stoul stoull string "
               "to_string"},
    {"string_view", "begin end ptrdiff_t size size_t string_view string_view_literals"},
    {"system_error", "errc error_code generic_category make_error_code system_category system_error"},
    {"thread", "jthread this_thread thread"},
    {"tuple", "apply get tie tuple make_tuple ignore tuple_size_v"},
    {"type_traits",
     "conditional_t decay_t enable_if_t false_type invoke_result_t is_enum_v is_floating_point_v "
     "is_integral_v "
     "is_same_v is_copy_constructible_v is_move_constructible_v is_trivially_copyable_v remove_cvref_t "
     "remove_pointer_t remove_reference_t true_type "
     "underlying_type_t is_constructible_v is_base_of_v void_t is_arithmetic_v is_signed_v is_void_v is_class_v "
     "type_identity_t"},
    {"unordered_map", "begin end erase erase_if ptrdiff_t size size_t unordered_map"},
    {"unordered_set", "begin end erase erase_if ptrdiff_t size size_t unordered_set"},
    {"utility",
     "as_const cmp_equal cmp_greater cmp_less declval exchange forward get in_place index_sequence "
     "integer_sequence "
     "make_index_sequence make_pair move pair ptrdiff_t size_t swap to_underlying initializer_list in_range"},
    {"variant", "get get_if holds_alternative monostate variant visit variant_size_v variant_alternative_t"},
    {"vector", "begin end erase erase_if initializer_list ptrdiff_t size size_t vector"},
};

/// For each name, the headers that will do.
std::map<std::string, std::vector<std::string_view>> headersOfNames() {
  std::map<std::string, std::vector<std::string_view>> headers;
  for (const auto& [header, names] : kHeaders) {
    std::istringstream words{std::string(names)};
    for (std::string name; words >> name;) headers[name].push_back(header);
  }
  return headers;
}

/// The text with every raw string literal emptied.
std::string withoutRawStrings(std::string text) {
  for (std::size_t at = text.find("R\""); at != std::string::npos; at = text.find("R\"", at + 2)) {
    const std::size_t open = text.find('(', at);
    if (open == std::string::npos) break;
    const std::string close = ")" + text.substr(at + 2, open - at - 2) + "\"";
    const std::size_t end = text.find(close, open);
    if (end != std::string::npos) text.erase(at + 2, end + close.size() - at - 3);
  }
  return text;
}

/// The lines that say std::, without comments and string literals, whose names are not uses.
std::string codeOf(const std::string& text) {
  static const std::regex kComment("//[^\n]*");
  static const std::regex kLiteral(R"re("(\\.|[^"\\\n])*")re");
  std::ostringstream code;
  std::istringstream lines(withoutRawStrings(text));
  for (std::string line; std::getline(lines, line);)
    if (line.find("std::") != std::string::npos)
      code << std::regex_replace(std::regex_replace(line, kLiteral, "\"\""), kComment, "") << '\n';
  return code.str();
}

std::set<std::string> includesOf(const std::string& text) {
  static const std::regex kInclude(R"re(#include <([a-z_]+)>)re");
  std::set<std::string> includes;
  for (std::sregex_iterator match(text.begin(), text.end(), kInclude), end; match != end; ++match)
    includes.insert((*match)[1]);
  return includes;
}

std::set<std::string> namesOf(const std::string& text) {
  static const std::regex kName(R"re(\bstd::((ranges::)?[A-Za-z_]\w*))re");
  std::set<std::string> names;
  const std::string code = codeOf(text);
  for (std::sregex_iterator match(code.begin(), code.end(), kName), end; match != end; ++match)
    names.insert((*match)[1]);
  return names;
}

/// A sentence for each name of a file's code that none of `includes` brings.
std::string missingIn(const std::string& file, const std::string& text,
                      const std::set<std::string>& includes) {
  static const auto kNames = headersOfNames();
  std::string missing;
  for (const std::string& name : namesOf(text)) {
    const auto found = kNames.find(name);
    if (found == kNames.end()) {
      missing += file + " uses std::" + name + ", which the table of this test does not know\n";
    } else if (std::ranges::none_of(found->second, [&](std::string_view header) {
                 return includes.contains(std::string(header));
               })) {
      missing += file + " uses std::" + name + " and does not include <" +
                 std::string(found->second.front()) + ">\n";
    }
  }
  return missing;
}

} // namespace

TEST(StandardIncludes, EveryFileIncludesWhatItUses) {
  std::string missing;
  int files = 0;
  for (const char* folder : {"core", "app", "tests", "shaders"}) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
      const fs::path& path = entry.path();
      if (path.extension() != ".h" && path.extension() != ".cpp") continue;
      const std::string text = taa::readFile(path);
      std::set<std::string> includes = includesOf(text);
      // What a file's own header includes is there wherever the file is.
      const fs::path header = fs::path(path).replace_extension(".h");
      if (path.extension() == ".cpp" && fs::exists(header)) includes.merge(includesOf(taa::readFile(header)));
      missing += missingIn(path.generic_string(), text, includes);
      ++files;
    }
  }
  EXPECT_GT(files, 500);
  EXPECT_EQ(missing, "");
}

TEST(StandardIncludes, AreMissedWhereTheyAreNot) {
  const std::string text = "#include <vector>\nint a = std::max(1, 2); // std::sort\nstd::vector<int> b; "
                           "auto c = \"std::find\";\n";
  EXPECT_EQ(missingIn("a.cpp", text, includesOf(text)),
            "a.cpp uses std::max and does not include <algorithm>\n");
  EXPECT_EQ(missingIn("a.cpp", text, {"algorithm", "vector"}), "");
  EXPECT_EQ(missingIn("a.cpp", "std::fancy()", {}),
            "a.cpp uses std::fancy, which the table of this test does not know\n");
}
