#include "background.h"

#include <rviz/display_group.h>
#include <rviz/visualization_manager.h>

#include "colours.h"
#include "widgets.h"

namespace poinsot::rviz_panel {

Background::Background(rviz::VisualizationManager* manager)
    : QCheckBox("&Light background"),
      colour_(dynamic_cast<rviz::ColorProperty*>(
          manager->getRootDisplayGroup()->subProp("Global Options")->subProp("Background Color"))) {
  describe(this, "light_background", "For paper and bright rooms.");
  if (!colour_) return;
  connect(this, &QCheckBox::clicked, this,
          [this](bool on) { colour_->setColor(on ? colours::kLightBackground : colours::kDarkBackground); });
  connect(colour_, &rviz::Property::changed, this, &Background::showColour);
  showColour();
}

void Background::showColour() {
  setChecked(colour_->getColor().lightnessF() > 0.5);  // which is no click
}

}  // namespace poinsot::rviz_panel
