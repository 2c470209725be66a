#include "reference_rows.h"

#include <cstdlib>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>

namespace poinsot {
namespace {

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> out(1);
  for (const char c : line) {
    if (c == ',') {
      out.emplace_back();
    } else if (c != '\r') {
      out.back() += c;
    }
  }
  return out;
}

class Row {
 public:
  Row(const std::map<std::string, std::size_t>& columns, std::vector<std::string> values)
      : columns_(columns), values_(std::move(values)) {
    if (values_.size() != columns_.size()) throw std::runtime_error("row of another length: " + values_[0]);
  }
  const std::string& text(const std::string& name) const { return values_.at(columns_.at(name)); }
  double number(const std::string& name) const { return parsed(name, std::strtod); }
  long double longNumber(const std::string& name) const { return parsed(name, std::strtold); }
  double numberOrNaN(const std::string& name) const {
    return text(name).empty() ? std::numeric_limits<double>::quiet_NaN() : number(name);
  }
  /** The input of that name, which stands there twice. */
  double input(const std::string& name) const {
    if (number(name) != number(name + "_hex"))
      throw std::runtime_error(values_[0] + ": " + name + " contradicts itself");
    return number(name + "_hex");
  }

 private:
  template <class Number>
  Number parsed(const std::string& name, Number (*parse)(const char*, char**)) const {
    char* end = nullptr;
    const Number value = parse(text(name).c_str(), &end);
    if (text(name).empty() || *end) throw std::runtime_error(values_[0] + ": " + name + " is not a number");
    return value;
  }

  const std::map<std::string, std::size_t>& columns_;
  std::vector<std::string> values_;
};

}  // namespace

std::vector<ReferenceRow> readReferenceRows(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error("cannot read " + path);
  std::map<std::string, std::size_t> columns;
  std::vector<ReferenceRow> rows;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    const std::vector<std::string> values = cells(line);
    if (columns.empty()) {
      for (std::size_t i = 0; i < values.size(); ++i) columns[values[i]] = i;
      continue;
    }
    const Row row(columns, values);
    rows.push_back({row.text("id"),
                    row.text("note"),
                    {row.input("mu1"), row.input("mu2"), row.input("mu3")},
                    {row.input("q0w"), row.input("q0x"), row.input("q0y"), row.input("q0z")},
                    {row.input("O01"), row.input("O02"), row.input("O03")},
                    row.input("t"),
                    {row.number("qw"), row.number("qx"), row.number("qy"), row.number("qz")},
                    {row.number("O1"), row.number("O2"), row.number("O3")},
                    {row.longNumber("qw"), row.longNumber("qx"), row.longNumber("qy"), row.longNumber("qz")},
                    {row.longNumber("O1"), row.longNumber("O2"), row.longNumber("O3")},
                    row.numberOrNaN("cond_rad"),
                    row.numberOrNaN("cond_omega")});
  }
  return rows;
}

}  // namespace poinsot
