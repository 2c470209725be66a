#pragma once

#include <istream>
#include <stdexcept>
#include <string>
#include <vector>

namespace poinsot::tools {

/** What is wrong with a table, and on which physical line (from 1). what() is "line N: reason". */
class CsvError : public std::runtime_error {
 public:
  CsvError(long line, const std::string& reason) : std::runtime_error("line " + std::to_string(line) + ": " + reason) {}
};

struct CsvRow {
  long line;                       ///< physical line, from 1
  std::vector<std::string> cells;  ///< those of the columns asked for, in that order, as they stand there
};

/**
 * Reads a table, its first line the header, and picks the columns asked for by name. What separates cells is what
 * separates the names of the header: commas, or else semicolons, or else tabs.
 *
 * Lines that begin with '#' and lines with nothing but blanks are skipped; line ends may be LF or CRLF, the last may be
 * missing. Throws CsvError for no header, a wanted column that is missing or there twice, a row with another number of
 * cells than the header, a comma in a wanted cell, and for quotes and UTF-16, which this reader does not know.
 */
std::vector<CsvRow> readCsvRows(std::istream& in, const std::vector<std::string>& columns);

/**
 * A decimal or C hexadecimal floating-point number, rounded to the nearest double, with nothing but blanks around it.
 * Throws std::invalid_argument, saying what is wrong, for anything else, NaN and infinity included.
 */
double parseNumber(const std::string& text);

}  // namespace poinsot::tools
