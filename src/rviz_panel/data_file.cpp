#include "data_file.h"

#include <ros/package.h>
#include <rviz/yaml_config_reader.h>

#include <QFile>

namespace poinsot::rviz_panel::data_file {
namespace {

constexpr qint64 kLargest = 65536;  // bytes

}  // namespace

QString read(const QString& name) {
  QFile file(QString::fromStdString(ros::package::getPath("poinsot")) + "/panel/" + name);
  if (!file.open(QIODevice::ReadOnly)) throw Error(file.fileName(), "a file", "none that can be read");
  const QByteArray text = file.read(kLargest + 1);
  if (text.size() > kLargest) throw Error(file.fileName(), QString("at most %1 bytes").arg(kLargest), "more");
  return QString::fromUtf8(text);
}

rviz::Config listFrom(const QString& text, const QString& place, int most) {
  rviz::Config out;
  rviz::YamlConfigReader reader;
  reader.readString(out, text, place);
  if (reader.error()) throw Error(place, "YAML", reader.errorMessage());
  const QString list = QString("a list of 1 to %1 entries").arg(most);
  if (out.getType() != rviz::Config::List) throw Error(place, list, "something else");
  if (out.listLength() < 1 || out.listLength() > most) throw Error(place, list, QString::number(out.listLength()));
  return out;
}

QString textOf(const rviz::Config& map, const QString& key, const QString& place, int longest) {
  QString out;
  const QString expected = QString("a text of 1 to %1 letters under %2").arg(longest).arg(key);
  if (!map.mapGetString(key, &out)) throw Error(place, expected, "none");
  if (out.isEmpty() || out.size() > longest) throw Error(place, expected, QString("one of %1").arg(out.size()));
  return out;
}

}  // namespace poinsot::rviz_panel::data_file
