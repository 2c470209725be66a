#pragma once

#include <QString>
#include <QStringList>
#include <string>
#include <vector>

/** Figures as text that is short enough for a narrow panel. */
namespace poinsot::rviz_panel::text {

inline const QString kUnknown = "–";

/** Returns a time in seconds such as "12.35", without its unit; large ones with as many digits as doubles have. */
QString time(double value);

/** Returns the same with its unit; "∞ s", "–" for NaN. */
QString seconds(double value);

/** Returns the number that the user typed: with a comma or a point, any minus sign, spaces around it. */
double number(const QString& text, bool* ok);

/** Returns the value with an SI prefix and the unit: "1.3 µs", "4.53 kJ"; "0 J". */
QString withPrefix(double value, const QString& unit, int digits = 3);

/** Returns texts such as "1.2e−16", "0.0123" and "0". */
QString small(double value);

/** Returns texts such as "×2", "×0.05" and "×−1". */
QString speed(double value);

QStringList list(const std::vector<std::string>& texts);

/** Returns up to `digits` significant digits, with a true minus sign. */
QString plain(double value, int digits = 6);

}  // namespace poinsot::rviz_panel::text
