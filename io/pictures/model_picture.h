// A picture of a case before it runs: blocks, joints by their law, supports, loads, water, monitors, motions.
#pragma once

#include <filesystem>
#include <optional>

#include "model/model.h"

namespace scree::io {

struct ModelPictureOptions {
  bool names = false;         // of the blocks
  int width = 1680;           // of a PNG [pixels]
  std::optional<Box> window;  // what to show [m], in the coordinates of the model; empty: everything
};

/// Draws a model. Blocks are tinted by material; blocks that are held whole are hatched. Faces between blocks, and
/// cracks (dashed), have the colour of their joint law, free faces are black. Held edges carry hatching where they are
/// fixed and rollers where they slide; supported points are triangles. Tractions and point loads are arrows. Below the
/// section stands each motion's acceleration over time. The legend contains only what the picture shows.
/// @param file  .png, .pdf or .svg     @throws FileError
void draw_model(const Model& model, const ModelPictureOptions& options, const std::filesystem::path& file);

}  // namespace scree::io
