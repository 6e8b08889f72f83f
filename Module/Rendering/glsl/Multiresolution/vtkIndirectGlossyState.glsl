// States of a texel in the pyramid of specular lobes.
const float VTKI_GLOSSY_NONE = 0.0f;  // no specular pixel
const float VTKI_GLOSSY_WHOLE = 1.0f; // one evaluation of a light can represent the texel
const float VTKI_GLOSSY_SPLIT = 2.0f; // several surfaces or lobes: evaluate its children
