// The metallic-roughness model of glTF 2.0, appendix B: GGX with height-correlated Smith visibility (in the
// form of Hammon, "PBR Diffuse Lighting for GGX+Smith Microsurfaces", 2017, without square roots) and
// Schlick's Fresnel; diffuse is Lambert. Vectors are normalized, world space.

const float kPi = 3.14159265;

struct Surface {
  vec3 diffuse;    // albedo of the diffuse part
  vec3 specular;   // reflectance at normal incidence
  float roughness; // perceptual, 0…1
  float alpha;     // of GGX: roughness²
  float alpha2;
  vec3 normal;
  vec3 toCamera;
  float cosCamera; // normal · toCamera, at least a little above 0
};

Surface makeSurface(vec3 baseColor, float metallic, float roughness, vec3 normal, vec3 toCamera) {
  Surface surface;
  surface.diffuse = baseColor * (1.0 - metallic);
  surface.specular = mix(vec3(0.04), baseColor, metallic);
  surface.roughness = clamp(roughness, 0.089, 1.0); // below it highlights of a point-like light leave 16 bits
  surface.alpha = surface.roughness * surface.roughness;
  surface.alpha2 = surface.alpha * surface.alpha;
  surface.normal = normal;
  surface.toCamera = toCamera;
  surface.cosCamera = clamp(dot(normal, toCamera), 1e-3, 1.0);
  return surface;
}

/// Sums over lights, from which radiance is made once: Schlick's f0 + (1 − f0)·g is split into f0·(1 − g) and g.
struct Reflection {
  vec3 diffuse;  // irradiance
  vec3 facing;   // irradiance · lobe · (1 − g)
  vec3 grazing;  // irradiance · lobe · g
};

/// Adds a light of `irradiance` on a plane that faces it.
void addLight(inout Reflection sum, Surface surface, vec3 irradiance, vec3 toLight) {
  float cosCamera = surface.cosCamera;
  float cosLight = max(dot(surface.normal, toLight), 0.0);
  // Angles of the half vector h = (l + v) / |l + v| without making it: |l + v|² = 2 + 2 l·v.
  float cosBetween = dot(toLight, surface.toCamera);
  float inverseLength = inversesqrt(max(2.0 + 2.0 * cosBetween, 1e-6));
  float cosHalf = (cosLight + cosCamera) * inverseLength;
  float rest = 1.0 - (1.0 + cosBetween) * inverseLength;
  float rest2 = rest * rest;
  float grazing = rest2 * rest2 * rest;

  float spread = 1.0 + (surface.alpha2 - 1.0) * min(cosHalf * cosHalf, 1.0);
  float shadowing = mix(2.0 * cosLight * cosCamera, cosLight + cosCamera, surface.alpha);
  float lobe = 0.5 * surface.alpha2 / (spread * spread * shadowing);
  irradiance *= cosLight;
  sum.diffuse += irradiance;
  irradiance *= lobe;
  sum.grazing += irradiance * grazing;
  sum.facing += irradiance - irradiance * grazing;
}

/// Radiance towards the camera.
vec3 reflectedRadiance(Reflection sum, Surface surface) {
  return (surface.diffuse * sum.diffuse + surface.specular * sum.facing + sum.grazing) * (1.0 / kPi);
}

/// Share of a uniform environment that the specular part reflects: the analytic fit of Karis, "Physically
/// Based Shading on Mobile" (2014).
vec3 environmentReflectance(Surface surface) {
  vec4 terms = surface.roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
  float grazing = min(terms.x * terms.x, exp2(-9.28 * surface.cosCamera)) * terms.x + terms.y;
  vec2 scaleBias = vec2(-1.04, 1.04) * grazing + terms.zw;
  return surface.specular * scaleBias.x + scaleBias.y;
}
