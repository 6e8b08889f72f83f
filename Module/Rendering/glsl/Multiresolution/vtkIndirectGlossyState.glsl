// States of a texel in the pyramid of specular lobes.
const float VTKI_GLOSSY_NONE = 0.0f;  // nothing specular in it
const float VTKI_GLOSSY_WHOLE = 1.0f; // one evaluation of a light can stand for all of it
const float VTKI_GLOSSY_SPLIT = 2.0f; // of several surfaces or lobes: its children are looked at
