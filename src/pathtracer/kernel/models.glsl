// What kernel.ts writes for the models of a scene: each function asks which one it is.

// The values of the material's parameters at the present surface, as many as the kernel's models have at most.
vec3 surfaceParameters[MAX_PARAMETERS];
// Gives them to the model.
void setParameters(uint model);
// The model in 1/sr, for L and the present surface.
vec3 modelBRDF(uint model, vec3 L);
// A direction drawn about as the model reflects, or 0; and its density in 1/sr.
vec3 modelSample(uint model, vec2 u);
float modelPdf(uint model, vec3 L);
void readParameters(int slot, int count);
// Of models that let light through: the index of refraction, which is read as the body's own and set to the far
// side's over the near side's; whether the surface is a sheet; and what fills the body.
float modelIor(uint model);
void setModelIor(uint model, float ior);
bool modelIsThin(uint model);
vec3 modelExtinction(uint model);
vec3 modelScattering(uint model);
float modelAnisotropy(uint model);
