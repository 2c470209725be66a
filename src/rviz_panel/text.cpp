#include "text.h"

#include <cmath>
#include <utility>

namespace poinsot::rviz_panel::text {
namespace {

QString withMinus(QString text) {
  return text.replace('-', QChar(0x2212));
}

}  // namespace

QString time(double value) {
  const QString number = std::abs(value) < 1e12 ? QString::number(value, 'f', 2) : QString::number(value, 'g', 15);
  return withMinus(number == "-0.00" ? "0.00" : number);
}

QString seconds(double value) {
  if (std::isnan(value)) return kUnknown;
  if (std::isinf(value)) return value > 0 ? "∞ s" : "−∞ s";
  return time(value) + " s";
}

double number(const QString& text, bool* ok) {
  QString plain = text.trimmed();
  plain.replace(QChar(0x2212), '-').replace(',', '.');
  return plain.toDouble(ok);
}

QString withPrefix(double value, const QString& unit, int digits) {
  if (!std::isfinite(value)) return kUnknown;
  static constexpr std::pair<double, const char*> kPrefixes[] = {
      {1e12, "T"}, {1e9, "G"}, {1e6, "M"}, {1e3, "k"}, {1, ""}, {1e-3, "m"}, {1e-6, "µ"}, {1e-9, "n"}, {1e-12, "p"}};
  const double size = std::abs(value);
  if (size == 0) return "0 " + unit;
  for (const auto& [factor, letter] : kPrefixes) {
    if (size < factor || size >= 1e15) continue;
    QString number = plain(value / factor, digits);
    if (number.contains('e')) number = withMinus(QString::number(value / factor, 'f', 0));  // 999.9 in three digits
    return number + " " + letter + unit;
  }
  return plain(value, digits) + " " + unit;
}

QString small(double value) {
  if (std::isnan(value)) return kUnknown;
  if (std::abs(value) >= 1e-3 && std::abs(value) < 1e4) return plain(value, 3);
  const QString number = QString::number(value, 'e', 1);
  const int e = number.indexOf('e');
  return value == 0 ? QString("0") : withMinus(number.left(e + 1) + QString::number(number.mid(e + 1).toInt()));
}

QString speed(double value) {
  return "×" + plain(value, 3);
}

QStringList list(const std::vector<std::string>& texts) {
  QStringList out;
  for (const std::string& text : texts) out << QString::fromStdString(text);
  return out;
}

QString plain(double value, int digits) {
  if (std::isnan(value)) return kUnknown;
  return withMinus(QString::number(value, 'g', digits));
}

}  // namespace poinsot::rviz_panel::text
