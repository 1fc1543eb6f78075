// Random bits of whole numbers, the same on every driver.

/// PCG's permutation (O'Neill 2014; Jarzynski and Olano 2020).
uint hashed(uint x) {
  uint state = x * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}
