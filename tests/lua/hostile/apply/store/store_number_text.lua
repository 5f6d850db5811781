-- tries to get a text that is converted slowly out of the store
-- expect: error
store.script.text = '1' .. 'e' .. '308'
while true do local x = store.script.text + 0 end
