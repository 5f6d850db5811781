-- tries to fail in the handler of errors, again and again
-- expect: limit
while true do xpcall(error, function() error('again') end) end
