#include "command_line.h"

#include <algorithm>
#include <filesystem>

#include "csv_rows.h"

namespace poinsot::tools {

CLI::Option* addPositive(CLI::App& app, const std::string& name, std::optional<double>& value, const std::string& unit,
                         const std::string& description) {
  const auto read = [&value, name, unit](const std::string& text) {
    value = parseNumber(text);
    if (value && *value > 0) return;
    throw CLI::ValidationError(
        name, "expected a positive finite number" + (unit.empty() ? "" : " (" + unit + ")") + ", got \"" + text + '"');
  };
  CLI::Option* option = app.add_option_function<std::string>(name, read, description);
  if (value) option->default_str(CLI::detail::to_string(*value));
  return option;
}

CLI::Validator notEmpty() {
  const auto check = [](const std::string& text) { return text.empty() ? "expected a value, got \"\"" : ""; };
  return CLI::Validator(check, "");
}

CLI::Validator oneOf(const std::vector<std::string>& words) {
  const std::string known = "one of " + CLI::detail::join(words, ", ");
  const auto check = [=](const std::string& word) {
    const bool is_known = std::find(words.begin(), words.end(), word) != words.end();
    return is_known ? "" : "expected " + known + ", got \"" + word + '"';
  };
  return CLI::Validator(check, known);
}

void refuseSameFile(const std::string& option, const std::string& path, const std::string& other_name,
                    const std::string& other) {
  namespace fs = std::filesystem;
  if (fs::weakly_canonical(fs::absolute(path)) != fs::weakly_canonical(fs::absolute(other))) return;
  throw BadUse(option, "a file other than " + other_name, path);
}

std::optional<int> parse(CLI::App& app, int argc, char** argv) {
  app.failure_message([](const CLI::App* parsed, const CLI::Error& error) {
    return parsed->get_name() + ": " + CLI::FailureMessage::simple(parsed, error);
  });
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kBadUse;
  }
  return std::nullopt;
}

}  // namespace poinsot::tools
