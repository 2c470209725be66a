#include "csv_rows.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>

namespace poinsot::tools {
namespace {

constexpr char kBlanks[] = " \t";

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

std::vector<std::string> split(const std::string& line, char separator) {
  std::vector<std::string> cells;
  for (std::size_t begin = 0;;) {
    const std::size_t end = line.find(separator, begin);
    cells.push_back(line.substr(begin, end - begin));
    if (end == std::string::npos) return cells;
    begin = end + 1;
  }
}

/** Returns the separator of a header; tabs come last, because they may also stand as blanks around the others. */
char separatorOf(const std::string& header) {
  for (const char separator : {',', ';', '\t'}) {
    if (header.find(separator) != std::string::npos) return separator;
  }
  return ',';
}

/** The lines of a table without comments and blank lines. */
class Lines {
 public:
  explicit Lines(std::istream& in) : in_(in) {}

  bool next(std::string& line) {
    while (std::getline(in_, line)) {
      ++number_;
      if (number_ == 1) refuseWideText(line);
      if (number_ == 1 && line.compare(0, 3, "\xEF\xBB\xBF") == 0) line.erase(0, 3);  // a byte order mark
      if (!line.empty() && line.back() == '\r') line.pop_back();
      const std::size_t first = line.find_first_not_of(kBlanks);
      if (first == std::string::npos || line[first] == '#') continue;
      if (line.find('"') != std::string::npos) throw CsvError(number_, "expected cells without quotes, got a quote");
      return true;
    }
    return false;
  }

  long number() const { return number_; }

 private:
  static void refuseWideText(const std::string& line) {
    const std::string begin = line.substr(0, 2);
    if (begin == "\xFF\xFE" || begin == "\xFE\xFF" || line.find('\0') != std::string::npos) {
      throw CsvError(1, "expected UTF-8, got UTF-16 (or another text with NUL bytes)");
    }
  }

  std::istream& in_;
  long number_ = 0;
};

/** Returns the place of each column in the header. */
std::vector<std::size_t> places(long line, const std::vector<std::string>& header,
                                const std::vector<std::string>& columns) {
  std::vector<std::size_t> out;
  std::string missing;
  for (const std::string& column : columns) {
    const auto found = std::find(header.begin(), header.end(), column);
    if (found == header.end()) {
      missing += (missing.empty() ? "" : ", ") + column;
    } else if (std::find(found + 1, header.end(), column) != header.end()) {
      throw CsvError(line, "expected every column once, got " + column + " twice");
    }
    out.push_back(found - header.begin());
  }
  if (!missing.empty()) throw CsvError(line, "expected a header with all columns, got one that lacks " + missing);
  return out;
}

}  // namespace

std::vector<CsvRow> readCsvRows(std::istream& in, const std::vector<std::string>& columns) {
  Lines lines(in);
  std::string line;
  if (!lines.next(line)) throw CsvError(lines.number() + 1, "expected a header, got the end of the input");
  const char separator = separatorOf(line);
  std::vector<std::string> header = split(line, separator);
  for (std::string& name : header) name = trimmed(name);
  const std::vector<std::size_t> wanted = places(lines.number(), header, columns);

  std::vector<CsvRow> rows;
  while (lines.next(line)) {
    const std::vector<std::string> cells = split(line, separator);
    if (cells.size() != header.size()) {
      throw CsvError(lines.number(), "expected " + std::to_string(header.size()) + " cells as in the header, got " +
                                         std::to_string(cells.size()));
    }
    CsvRow row{lines.number(), {}};
    for (const std::size_t place : wanted) {
      // A comma would divide the cell in the output; in a number, it might be meant as a decimal point.
      if (cells[place].find(',') != std::string::npos) {
        throw CsvError(lines.number(),
                       header[place] + ": expected a decimal point and no comma, got \"" + cells[place] + "\"");
      }
      row.cells.push_back(cells[place]);
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::optional<double> parseNumber(const std::string& text) {
  const std::string number = trimmed(text);
  // strtod rounds correctly and reads hexadecimal; no program here calls setlocale(), so its point is '.'. It would
  // skip leading white space of other kinds, and stop at a NUL.
  char* end = nullptr;
  const double value = std::strtod(number.c_str(), &end);
  const bool whole =
      !number.empty() && end == number.c_str() + number.size() && !std::isspace(static_cast<unsigned char>(number[0]));
  return whole && std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
}

}  // namespace poinsot::tools
