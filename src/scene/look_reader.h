#pragma once

#include <Eigen/Core>

#include "fields.h"
#include "poinsot/scene/scene.h"

namespace poinsot::scene {

/**
 * Reads how a body is shown: its pictures and its colour, and whether it stands with L upwards, which turns its
 * attitude at the start. Its inertia, attitude, spin and effects are there already.
 */
void readLook(const Fields& fields, Body& body);

/** Reads red, green and blue from 0 to 1. */
Eigen::Vector3d readColour(const Place& place);

/** Reads a line or words that a scene draws. */
Drawing readDrawing(const Place& place);

}  // namespace poinsot::scene
