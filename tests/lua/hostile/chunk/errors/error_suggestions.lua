-- tries to be given suggestions for ever, for which all names are compared
-- expect: limit
while true do pcall(function() return abcdefghijklmnopqrstuvwxyzabcdefghijklmnopqrstuvwxyz end) end
