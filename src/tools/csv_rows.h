#pragma once

#include <istream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace poinsot::tools {

/** A table that cannot be used; what() is "line N: reason", with the physical line, from 1. */
class CsvError : public std::runtime_error {
 public:
  CsvError(long line, const std::string& reason) : std::runtime_error("line " + std::to_string(line) + ": " + reason) {}
};

struct CsvRow {
  long line;                       ///< physical line, from 1
  std::vector<std::string> cells;  ///< of the requested columns, in the requested order, verbatim
};

/**
 * Returns the rows of a table whose first line is the header, with the cells of the requested columns. Cells are
 * separated as the names of the header are: by commas, or else semicolons, or else tabs.
 *
 * Lines that begin with '#' and blank lines are skipped; line ends may be LF or CRLF, and the last may be missing.
 * Throws CsvError for a missing header, a requested column that is missing or there twice, a row with another number of
 * cells than the header, a comma in a requested cell, quotes, and UTF-16.
 */
std::vector<CsvRow> readCsvRows(std::istream& in, const std::vector<std::string>& columns);

/**
 * Returns a decimal or C hexadecimal floating-point number, rounded to the nearest double; nothing for a text that
 * holds anything but a finite number and blanks around it.
 */
std::optional<double> parseNumber(const std::string& text);

}  // namespace poinsot::tools
