# Ladders: faults without a number of the control, and what the command line shows of them.

FC-1101 = Merdiven programının bir kuralına uyulmamış
    .detail = { $word }
    .help = Hangi kural olduğunu kontrolün alarm numarası söyler.

FC-1102 = Merdiven programını çalıştırma ayarı kullanılamıyor
    .detail = { $setting }: { $value }; izin verilen: { $allowed }
    .help = Sinyali adıyla ya da X20.3 gibi adresiyle, değerini = arkasında verin.

FC-1420 = Merdiven programı bir kodu bitirmedi
    .detail = { $word }
    .help = Tanılama sayfasında hangi sinyali beklediğine bakın, tezgâhtaki nedeni giderin ve reset tuşuna basın.
FC-1421 = Merdiven programı rijit kılavuz çekmeye katılmıyor
    .help = RGTAP sinyali 0: merdiven programının M29 ile ne yaptığına bakın.
FC-1422 = Bu dalga biçimi kaydedilemez
    .detail = { $value }
    .help = Tezgâhta olan eksen ve sinyalleri yazın: en az bir tane, sığacağından çok değil.
FC-1423 = parametre anahtarı açık
    .help = Parametreler tamamlanınca kapatın ya da ayar sayfasında kabul edin.
FC-1424 = çalışan merdiven programı tezgâh dosyasındaki değil
    .help = Tezgâh çalışırken onun yerine kondu ve saklandı. Tezgâhın kendi merdiven programına dönmek için değişikliği geri alın ya da yeniden değiştirin.
FC-1425 = saklanan merdiven programı çalıştırılamıyor; tezgâhın kendi merdiven programı çalışıyor
    .help = Düzeltilmiş olanla değiştirin; saklananın yerini alır.
    .detail = satır { $line }
FC-1426 = yeni merdiven programı durdu ve geri alındı
    .help = Önceki çalışıyor. 1. düzeyde sonsuz döngü ya da fazla adım arayın.

label-ladder-checked = { $file }: { $steps } adım, { $first } adımı 1. düzeyde, { $signals } adlı sinyal
label-ladder-faults = { $count ->
    [one] 1 hata
   *[other] { $count } hata
}
label-ladder-on = 1
label-ladder-off = 0
label-ladder-ran = { $time } ms, 2. düzeyde { $rounds } tur, periyot başına en çok { $steps } adım
label-ladder-stopped = { $time } ms sonra durdu
label-ladder-legend = | kontak ya da giriş iletiyor, o iletmiyor, - ulaşılmadı; * arkasında hat enerjili
