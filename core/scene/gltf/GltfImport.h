// Hands a checked glTF document to tinygltf, which parses it and loads its buffers and encoded images.
#pragma once

namespace tinygltf {
class Model;
}

namespace taa {

struct GltfDocument;

/// Throws Error with the reason when tinygltf refuses the document, or would take too much memory for it.
/// Images stay encoded.
void importGltf(const GltfDocument& document, tinygltf::Model& model);

} // namespace taa
