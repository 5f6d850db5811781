-- tries to hide an operator behind two characters that are one line end
-- expect: refused
local a = "\
" return 2 ^ 0.5 --"
