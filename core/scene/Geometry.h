// What loader and builders both need to finish a mesh: normals, tangents, bounds.
#pragma once

#include "core/scene/Scene.h"

namespace taa {

/// Gives every triangle its own three vertices with the face's normal, as glTF asks where normals are
/// missing, and morph targets the way to the normal of the moved face. Lines and points get a normal along
/// +y, so that the sky lights them.
void makeFlatNormals(Primitive& primitive);

/// Gives each morph target the way to the smooth normals of the moved mesh, from the faces around each
/// vertex.
void makeMorphNormals(Primitive& primitive);

/// Tangents along growing u of the normal map, summed over a vertex's triangles.
/// The bitangent cross(normal, tangent)·w points along falling v: up in the picture, as normal maps have it.
void makeTangents(Primitive& primitive, const TextureSlot& normalMap = {});

/// Sets `primitive.bounds` from its vertices.
void updateBounds(Primitive& primitive);

/// World bounds of everything drawn, all nodes at rest; empty when nothing is.
Bounds restBounds(const Scene& scene);

} // namespace taa
