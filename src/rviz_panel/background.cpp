#include "background.h"

#include <rviz/display_group.h>
#include <rviz/properties/color_property.h>
#include <rviz/visualization_manager.h>

#include "colours.h"
#include "widgets.h"

namespace poinsot::rviz_panel {
namespace {

rviz::ColorProperty* backgroundOf(const rviz::VisualizationManager& manager) {
  return dynamic_cast<rviz::ColorProperty*>(
      manager.getRootDisplayGroup()->subProp("Global Options")->subProp("Background Color"));
}

}  // namespace

bool isBackgroundLight(const rviz::VisualizationManager& manager) {
  const rviz::ColorProperty* const colour = backgroundOf(manager);
  return colour && colour->getColor().lightnessF() > 0.5;
}

QCheckBox* makeBackgroundBox(rviz::VisualizationManager* manager) {
  auto* const box = makeButton<QCheckBox>("&Light background", "light_background", "For paper and bright rooms.");
  rviz::ColorProperty* const colour = backgroundOf(*manager);
  if (!colour) return box;
  const auto show = [box, colour] { box->setChecked(colour->getColor().lightnessF() > 0.5); };  // which is no click
  QObject::connect(colour, &rviz::Property::changed, box, show);
  QObject::connect(box, &QCheckBox::clicked, colour, [colour](bool light) {
    colour->setColor(light ? colours::kLightBackground : colours::kDarkBackground);
  });
  show();
  return box;
}

}  // namespace poinsot::rviz_panel
