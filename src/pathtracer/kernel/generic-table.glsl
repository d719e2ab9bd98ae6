// What scene/generic-table.ts makes the generic sampler's table of: the model, looked at through the table's cells.

vec3 surfaceV;
vec3 surfaceN;
vec3 surfaceX;
vec3 surfaceY;

// Points along each side of a cell; GENERIC_TABLE.points in scene/layout.ts is its square.
const int CELL_POINTS = 2;

// The luminance of f: neither negative nor NaN.
float luminanceOfModel(vec3 L) {
  float f = luminance(modelBRDF(0u, L));
  return f > 0.0 && f < INFINITY ? f : 0.0;
}

// The model's parameters, from this slot on.
void setMaterial(int slot, int count) {
  for (int i = 0; i < MAX_PARAMETERS; i++)
    if (i < count) surfaceParameters[i] = loadFloat4(slot + i).xyz;
  setParameters(0u);
}

// For each cell of the view from v a slot of the film: the integrals over the directions l above, by reflection, of
// f cos and cos, and those below. Each of a cell's points is of another material, whose parameters are in a row.
void tabulateView(int slot, int count, float vx, float vy, float vz, float ior, bool isRound, bool transmits, bool isThin) {
  surfaceN = vec3(0.0, 0.0, 1.0);
  surfaceX = vec3(1.0, 0.0, 0.0);
  surfaceY = vec3(0.0, 1.0, 0.0);
  int throughWay = isThin ? THROUGH_SHEET : BY_REFRACTION;
  float rows = float(GENERIC_ROWS * CELL_POINTS);
  float columns = float(GENERIC_COLUMNS * CELL_POINTS);
  // Of a round table half the turn stands for both halves.
  float area = 2.0 * PI / (rows * columns);
  for (int i = 0; i < CELL_POINTS * CELL_POINTS; i++) {
    setMaterial(slot + i * count, count);
    if (transmits) setModelIor(0u, ior);
    // What the table's frame folds together is looked at in turn.
    int inRow = i / CELL_POINTS;
    int inColumn = i % CELL_POINTS;
    vec2 fold = isRound ? vec2(1.0, (inRow + inColumn) % 2 == 0 ? 1.0 : -1.0)
      : vec2(inColumn == 0 ? 1.0 : -1.0, inRow == 0 ? 1.0 : -1.0);
    vec3 v = vec3(vec2(vx, vy) * fold, vz);
    surfaceV = v;
    int cell = 0;
    while (cell < GENERIC_ROWS * GENERIC_COLUMNS) {
      float x = (float((cell / GENERIC_COLUMNS) * CELL_POINTS + inRow) + 0.5) / rows;
      float phi = (float((cell % GENERIC_COLUMNS) * CELL_POINTS + inColumn) + 0.5) / columns * (isRound ? PI : 2.0 * PI);
      vec3 h = gridNormal(x, vec2(cos(phi), sin(phi)) * fold);
      float stretch = area * gridStretch(x);
      vec4 sum = i == 0 ? vec4(0.0) : filmLoad(cell);
      vec3 l = genericDirection(BY_REFLECTION, v, h, ior);
      if (l.z > 0.0) {
        float cosine = l.z * stretch * genericSpread(BY_REFLECTION, v, l, h, ior);
        sum.xy += cosine * vec2(luminanceOfModel(l), 1.0);
      }
      if (transmits) {
        l = genericDirection(throughWay, v, h, ior);
        if (l.z < 0.0) {
          float cosine = -l.z * stretch * genericSpread(throughWay, v, l, h, ior);
          sum.zw += cosine * vec2(luminanceOfModel(l), 1.0);
        }
      }
      filmStore(cell, sum);
      cell++;
    }
  }
}
