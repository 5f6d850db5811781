-- tries to hide an operator in what looks like a string
-- expect: refused
local a = "\z
" local x = 2 ^ 0.5 --"
