-- tries to make a vector of text
-- expect: error
return vec2('a', {})
