// Vertices that move other than with their node (manual 3.4 to 3.7): cache, morph targets, wind, skin, in this
// order. Specialised by kInfluenceSets, kMorphed, kCached and kWind. This frame and the previous one go through the
// same function, so that what does not move has exactly no motion.
layout(std430, binding = 0) readonly buffer Influences { vec4 influences[]; }; // joints, weights of each set
layout(std430, binding = 1) readonly buffer Deltas { vec4 deltas[]; };         // position, normal, tangent
layout(std430, binding = 2) readonly buffer Cache { vec4 cached[]; };          // position, normal, velocity
layout(std430, binding = 3) readonly buffer Joints { mat4 joints[]; };         // world from model; then the previous
layout(std430, binding = 4) readonly buffer MorphWeights { float morphWeights[]; }; // then the previous

struct Deformed {
  vec3 position;
  vec3 normal;
  vec3 tangent;
};

mat4 skinMatrix(int firstJoint) {
  precise mat4 sum = mat4(0.0);
  for (int set = 0; set < kInfluenceSets; ++set) {
    int place = 2 * (gl_VertexID * kInfluenceSets + set);
    ivec4 index = ivec4(influences[place]) + firstJoint;
    vec4 weight = influences[place + 1];
    sum += weight.x * joints[index.x] + weight.y * joints[index.y] + weight.z * joints[index.z] +
           weight.w * joints[index.w];
  }
  return sum;
}

/// The normal and tangent of a surface that a wave along x + z moves by `way` times its height, whose slope is given:
/// as if the wave were equally high all over. Cofactors of I + way·slopeᵀ for the normal.
void tilt(inout Deformed vertex, vec3 way, vec3 slope) {
  vertex.normal = (1.0 + dot(way, slope)) * vertex.normal - slope * dot(way, vertex.normal);
  vertex.tangent += way * dot(slope, vertex.tangent);
}

Deformed deformedVertex(vec3 position, vec3 normal, vec3 tangent, float bend, int firstJoint, int firstWeight,
                        float time, float secondsBack) {
  Deformed result = Deformed(position, normal, tangent);
  precise vec3 moved = position; // the same bits from the same numbers, however the compiler arranges them
  if (kCached) {
    int place = 3 * (draw.deform.z * draw.deformCounts.y + gl_VertexID);
    moved = cached[place].xyz - secondsBack * cached[place + 2].xyz;
    result.normal = cached[place + 1].xyz;
  }
  if (kMorphed) {
    for (int target = 0; target < draw.deformCounts.x; ++target) {
      int place = 3 * (target * draw.deformCounts.y + gl_VertexID);
      float weight = morphWeights[firstWeight + target];
      moved += weight * deltas[place].xyz;
      result.normal += weight * deltas[place + 1].xyz;
      result.tangent += weight * deltas[place + 2].xyz;
    }
  }
  if (kWind) {
    float phase = material.wind.y * (moved.x + moved.z) + material.wind.z * time;
    moved += material.windDirection.xyz * (material.wind.x * bend * sin(phase));
    float slope = material.wind.x * bend * material.wind.y * cos(phase);
    tilt(result, material.windDirection.xyz, vec3(slope, 0.0, slope));
  }
  if (kInfluenceSets > 0) {
    mat4 skin = skinMatrix(firstJoint);
    moved = (skin * vec4(moved, 1.0)).xyz;
    result.tangent = mat3(skin) * result.tangent;
    // Cofactors, as the draw's own matrix of normals has them.
    result.normal = mat3(cross(skin[1].xyz, skin[2].xyz), cross(skin[2].xyz, skin[0].xyz),
                         cross(skin[0].xyz, skin[1].xyz)) * result.normal;
  }
  result.position = moved;
  return result;
}
